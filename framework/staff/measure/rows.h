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
    /// "wall": around glFinish for a topic that draws; "cpu": processor time of the thread; "gpu": timer queries. Empty
    /// until the method is prepared.
    std::string clock;
    Image picture, error_map;
    double error_map_max = 0;
    std::optional<BenchSweep> sweep;

    bool is_measured() const { return state == "measured"; }
    bool is_timed() const { return is_measured() && repeats > 0; }
    /// Returns whether the 90th percentile of the times is more than twice the 10th: other load may have decided the
    /// median.
    bool is_wide() const { return is_timed() && times.p90 > 2 * times.p10; }
};

/// Returns the rows of a scene, all in state "open".
std::vector<BenchRow> open_rows(const BenchTopic& topic, const BenchScene& scene);

/// The machine and the build, for each line of the CSV, and the kind of run.
struct BenchMachine {
    std::string cpu = {}, compiler = {}, commit = {};
    std::string renderer = "none";  ///< "none" if nothing was drawn
    bool is_quick = false;          ///< small sizes and few repeats: plots say so
    double load = 0;                ///< largest load average over a minute during the run; this program is a part of it
    unsigned processors = 0;        ///< 0: unknown
};
/// Returns the CPU's name as the system reports it.
std::string cpu_name();
/// Returns the system's load average over the last minute; 0 if it is unknown.
double load_average();
/// Returns a text such as "load 7.1 on 2 processors"; "" if the load is unknown.
std::string load_text(const BenchMachine& machine);
/// Returns the names of the rows' clocks, such as "cpu and wall"; "" if nothing was timed.
std::string clocks_of(std::span<const BenchRow> rows);

/// Returns a table for people, with a section for each scene. A star marks the rows with is_wide().
std::string bench_table(const BenchTopic& topic, std::span<const BenchRow> rows, const BenchMachine& machine);
/// Returns CSV (RFC 4180) with a header line. Unknown values are empty, not 0.
std::string bench_csv(std::span<const BenchRow> rows, const BenchMachine& machine);
/// Reads work and errors from the output of bench_csv(). Throws Error with the line for any other text.
std::vector<BenchRow> read_bench_csv(const std::string& text);

/// Returns the method and the values of its knobs that the method's name does not have. Numbers and switches have their
/// knob's name: "mikktspace 2 threads", "low 500", "whole tangent no gram schmidt".
std::string short_name(const BenchRow& row);
/// Returns a name that is unique among rows: "topic, scene, method, knobs".
std::string row_name(const BenchRow& row);

}  // namespace relief::measure
