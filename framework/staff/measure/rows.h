// The results of `relief bench`: a row for each method, written as a table or as CSV.
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
    /// "measured"; "open" before the result is known; else the reason for no result: "crashed: Segmentation fault".
    std::string state = "open";
    size_t items = 1;
    double bytes_per_item = 0;
    BenchWork work;
    BenchError error;
    int repeats = 0;   ///< number of samples; 0: not timed
    BenchTimes times;  ///< nanoseconds per item
    Image picture, error_map;
    double error_map_max = 0;
    std::optional<BenchSweep> sweep;

    bool is_measured() const { return state == "measured"; }
};

/// The rows of a scene, all in state "open".
std::vector<BenchRow> open_rows(const BenchTopic& topic, const BenchScene& scene);

/// The machine and the build, for each line of the CSV.
struct BenchMachine {
    std::string cpu = {}, compiler = {}, commit = {};
    std::string renderer = "none";  ///< "none" if nothing was drawn
    std::string clock = "wall";     ///< "wall": around glFinish for a topic that draws; "gpu": timer queries
};
/// The CPU's name as the system reports it.
std::string cpu_name();

/// A table for people, with a section for each scene.
std::string bench_table(const BenchTopic& topic, std::span<const BenchRow> rows);
/// CSV (RFC 4180) with a header line. Unknown values are empty, not 0.
std::string bench_csv(std::span<const BenchRow> rows, const BenchMachine& machine);
/// Reads work and errors from the text of bench_csv(). Throws Error with the line for any other text.
std::vector<BenchRow> read_bench_csv(const std::string& text);

/// "linear 32": the method and the values of its knobs.
std::string short_name(const BenchRow& row);
/// "topic, scene, method, knobs": a name that no other row has.
std::string row_name(const BenchRow& row);

}  // namespace relief
