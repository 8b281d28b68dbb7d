// The results of a method, as a line of a table, of a CSV, and as text from one process to another.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "framework/staff/measure/bench.h"

namespace relief {

struct BenchRow {
    std::string topic;
    BenchKnobs scene;
    std::string item, method;
    BenchKnobs knobs;
    bool peer = false;
    /// "measured"; "open" as long as nothing is known; else why there is no result: "crashed: Segmentation fault".
    std::string state = "open";
    size_t items = 1;
    double bytes_per_item = 0;
    BenchWork work;
    BenchError error;
    int repeats = 0;   ///< samples behind the times; 0: there are none
    BenchTimes times;  ///< nanoseconds an item
    Image picture, error_map;
    double error_map_max = 0;

    bool is_measured() const { return state == "measured"; }
};

/// The rows of a scene, all open.
std::vector<BenchRow> open_rows(const BenchTopic& topic, const BenchScene& scene);

/// The machine and the build, for each line of the CSV.
struct BenchMachine {
    std::string cpu = {}, compiler = {}, commit = {};
    std::string renderer = "none";  ///< what drew; "none" when only the CPU worked
    std::string clock = "wall";     ///< "wall", around glFinish where something draws; "gpu" by timer queries
};
/// The CPU's name as the system has it.
std::string cpu_name();

/// A table for people: a part for each scene.
std::string bench_table(const BenchTopic& topic, std::span<const BenchRow> rows);
/// RFC 4180, with a header line. Unknown values are empty: 0 would be a claim.
std::string bench_csv(std::span<const BenchRow> rows, const BenchMachine& machine);
/// Work and errors of bench_csv(). Throws Error with the line for anything else.
std::vector<BenchRow> read_bench_csv(const std::string& text);

/// "scene / method knobs", which is one row's alone.
std::string row_name(const BenchRow& row);

}  // namespace relief
