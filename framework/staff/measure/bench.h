// Run time against error: methods for the same purpose, timed interleaved and compared with exact values.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "framework/image/image.h"

namespace relief {

/// A method's distance from the exact values. No unit for a method that computes nothing.
struct BenchError {
    double mean = 0, p99 = 0, largest = 0;
    std::string unit = {};             ///< "degree", "texel"
    std::optional<double> wrong = {};  ///< share off by more than one unit, where that is a kind of its own
};

/// Work that does not depend on the clock: {"taps", 7.2}, {"triangles", 2048}. Per item, or per frame.
using BenchWork = std::vector<std::pair<std::string, double>>;
using BenchKnobs = std::vector<std::pair<std::string, std::string>>;

/// A method that is ready to run: its closure owns its data.
struct BenchSubject {
    size_t items = 1;           ///< that one run works on
    double bytes_per_item = 0;  ///< what it reads and writes, or stores; 0 where it is no claim
    BenchWork work = {};
    BenchError error = {};
    std::function<void()> run;
    Image picture = {}, error_map = {};  ///< to look at, 8 bits; empty where there is nothing to see
    double error_map_max = 0;            ///< what its brightest colour stands for, in the error's unit
};

/// A method. A topic lists it without any work; `prepare` does the work, with a context if the topic draws.
struct BenchMethod {
    std::string name;
    BenchKnobs knobs = {};  ///< how it is tuned: {"threads", "2"}
    std::function<BenchSubject()> prepare = {};
    bool peer = false;  ///< not of this course: another library, or what is commonly done
};

/// Methods that are compared with each other: one panel of a topic's plot.
struct BenchScene {
    BenchKnobs knobs = {};  ///< what they are all given: {"map", "bricks"}
    std::string item;       ///< "texel", "triangle": times are a nanosecond each
    std::vector<BenchMethod> methods = {};
};

struct BenchSettings {
    int repeats = 15;       ///< samples of each method; 0 for work and error alone
    bool quick = false;     ///< few scenes and small sizes, for a first look
    bool pictures = false;  ///< wants something to look at, where there is something
};

struct BenchTopic {
    std::string name, help;
    std::function<std::vector<BenchScene>(const BenchSettings&)> scenes;
    bool draws = false;      ///< wants a context, in which its methods are made, run and dropped
    bool only_time = false;  ///< knows of no work and no error
};
std::span<const BenchTopic> bench_topics();

/// Keeps what agrees with all of `wanted`, each a knob of a scene or of a method with the values it may have, or
/// "method" with names of methods. Throws UsageError, with what there is, for a knob or a value that is nowhere in the
/// topic.
std::vector<BenchScene> filter_scenes(const BenchTopic& topic, std::vector<BenchScene> scenes,
                                      std::span<const std::pair<std::string, std::vector<std::string>>> wanted);

/// "a=1 b=2".
std::string knob_text(const BenchKnobs& knobs);

/// A method's times, in nanoseconds an item.
struct BenchTimes {
    double median = 0, p10 = 0, p90 = 0;
};

/// Of a sample that is not empty: the value that a share of it does not exceed, between two values in proportion.
double quantile(std::vector<double> values, double share);

/// The figures over a sample of errors; all zero when it is empty.
BenchError error_figures(std::vector<double> errors, std::string unit);

/// Seconds of `n` runs.
using BenchClock = std::function<double(const std::function<void()>& run, size_t times)>;
/// By the wall clock. The work must be finished when a run returns: glFinish.
double by_wall_clock(const std::function<void()>& run, size_t times);

/// Subjects that are timed in turns: each round runs every one of them once, in a new order, so that whatever else the
/// machine does meets them all alike. Runs shorter than a millisecond are repeated within one sample.
class BenchTurns {
public:
    /// Runs each subject to warm up; `begin` is told of each run before it, by its place. What a run throws, it throws.
    BenchTurns(std::span<const BenchSubject> subjects, BenchClock clock, std::function<void(size_t)> begin = {});
    void round();
    /// At least one round must have been.
    std::vector<BenchTimes> times() const;

private:
    double take(size_t subject, size_t times);

    std::span<const BenchSubject> subjects_;
    BenchClock clock_;
    std::function<void(size_t)> begin_;
    std::vector<size_t> order_, runs_;
    std::vector<std::vector<double>> samples_;
    unsigned seed_ = 1;
};

/// Which methods no other is better than, in time and in error both. `points` are pairs of the two; a point that is
/// equal to another is on the front with it.
std::vector<bool> pareto_front(std::span<const std::pair<double, double>> points);

}  // namespace relief
