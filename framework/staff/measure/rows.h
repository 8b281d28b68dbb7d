// The results of `relief bench`: a row for each method, written as a table or as CSV.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "framework/staff/measure/bench.h"

namespace relief::measure {

struct BenchRow {
    std::string topic;
    BenchKnobs scene;
    std::string item, method;
    BenchKnobs knobs;
    bool peer = false;
    /// "measured"; "open" until the result is known; otherwise the reason for no result: "crashed: Segmentation fault".
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

/// Returns the rows of a scene, all in state "open".
std::vector<BenchRow> open_rows(const BenchTopic& topic, const BenchScene& scene);

/// The machine and the build, for each line of the CSV, and the kind of run.
struct BenchMachine {
    std::string cpu = {}, compiler = {}, commit = {};
    std::string renderer = "none";  ///< "none" if nothing was drawn
    std::string clock = "wall";     ///< "wall": around glFinish for a topic that draws; "gpu": timer queries
    bool is_quick = false;          ///< small sizes and few repeats: plots say so
};
/// Returns the CPU's name as the system reports it.
std::string cpu_name();

/// Returns a table for people, with a section for each scene.
std::string bench_table(const BenchTopic& topic, std::span<const BenchRow> rows);
/// Returns CSV (RFC 4180) with a header line. Unknown values are empty, not 0.
std::string bench_csv(std::span<const BenchRow> rows, const BenchMachine& machine);
/// Reads work and errors from the output of bench_csv(). Throws Error with the line for any other text.
std::vector<BenchRow> read_bench_csv(const std::string& text);

/// Returns the method and the values of its knobs, such as "linear 32".
std::string short_name(const BenchRow& row);
/// Returns a name that is unique among rows: "topic, scene, method, knobs".
std::string row_name(const BenchRow& row);

}  // namespace relief::measure
