// Run time against error: methods that do the same thing, timed in turns and measured against the truth.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace relief {

/// How far a method is from the truth. Of a peer that computes nothing: no unit.
struct BenchError {
    double mean = 0, p99 = 0, largest = 0;
    std::string unit = {};             ///< "degree", "texel"
    std::optional<double> wrong = {};  ///< share off by more than one unit, where that is a kind of its own
};

/// One way of doing it, ready to run: what it needs lives in its closures.
struct BenchMethod {
    std::string name;
    std::vector<std::pair<std::string, std::string>> knobs;  ///< what is swept: {"threads", "2"}
    size_t items = 1;                                        ///< that one run works on
    std::string item = "item";                               ///< "texel", "triangle": times are a nanosecond each
    double bytes_per_item = 0;        ///< what it reads and writes, or stores; 0 where it is no claim
    std::optional<double> work = {};  ///< what an item takes and no clock can move: heights read, cells looked at
    std::function<void()> run;
    BenchError error = {};
};

struct BenchSettings {
    int repeats = 15;    ///< samples of each method, at least 1
    bool quick = false;  ///< small sizes, for a first look
};

/// Makes the methods of one topic; that may take seconds.
struct BenchTopic {
    std::string name, help;
    std::function<std::vector<BenchMethod>(const BenchSettings&)> methods;
    bool draws = false;  ///< wants a context, in which its methods are made, run and dropped
};
std::span<const BenchTopic> bench_topics();

/// A method's times, in nanoseconds an item.
struct BenchTimes {
    double median = 0, p10 = 0, p90 = 0;
};

/// Of a sample that is not empty: the value that a share of it does not exceed, between two values in proportion.
double quantile(std::vector<double> values, double share);

/// The figures over a sample of errors; all zero when it is empty.
BenchError error_figures(std::vector<double> errors, std::string unit);

/// Runs every method once to warm up, then all of them `repeats` times, in a new order each time: whatever else the
/// machine does meets them all alike. Runs shorter than a millisecond are repeated within one sample. `clock` gives
/// seconds; `round` is called before each round.
std::vector<BenchTimes> time_in_turns(std::span<const BenchMethod> methods, int repeats,
                                      const std::function<double()>& clock, const std::function<void()>& round = {});

/// What is known of the machine and the build, for each line of the CSV.
struct BenchMachine {
    std::string cpu, compiler, commit;
    std::string renderer = "none";  ///< what drew; "none" when only the CPU worked
};
/// The CPU's name as the system has it.
std::string cpu_name();

/// A table for people, and the same as CSV (RFC 4180) with a header line.
std::string bench_table(const BenchTopic& topic, std::span<const BenchMethod> methods,
                        std::span<const BenchTimes> times);
std::string bench_csv(const BenchTopic& topic, std::span<const BenchMethod> methods, std::span<const BenchTimes> times,
                      const BenchSettings& settings, const BenchMachine& machine);

}  // namespace relief
