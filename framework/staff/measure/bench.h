// Run time against error: methods for the same purpose, timed interleaved and compared with exact values.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "framework/core/image/image.h"

namespace relief::measure {

/// A method's error against the exact values. `unit` is empty if the method has no error, like memcpy.
struct BenchError {
    double mean = 0, p99 = 0, largest = 0;
    std::string unit = {};             ///< "degree", "texel"
    std::optional<double> wrong = {};  ///< share of results that are off by more than one unit, if the topic counts it
};

/// Amounts of work, which do not depend on the clock: {"taps", 7.2}, {"triangles", 2048}. Per item, or per frame.
using BenchWork = std::vector<std::pair<std::string, double>>;
using BenchKnobs = std::vector<std::pair<std::string, std::string>>;

/// A method's error as a function of the difficulty of its input: a curve, in topics without a time.
struct BenchSweep {
    struct Place {
        double hardness = 1;    ///< the swept quantity: a scale, an angle's tangent; above 0
        double error = 0;       ///< of the finite results
        double not_finite = 0;  ///< share of results that are not finite or have no meaning
        double endless = 0;     ///< share of results that used up all iterations
    };
    double stated = 0;               ///< the error that the method promises, in the error's unit
    std::string why = {};            ///< a sentence: where it fails, and why
    std::vector<Place> places = {};  ///< in ascending order of hardness
};

/// A method that is ready to run. `run` owns its data; it is empty in a topic without times. In a topic that draws, the
/// GPU's work need not be finished when `run` returns.
struct BenchSubject {
    size_t items = 1;           ///< processed by one run
    double bytes_per_item = 0;  ///< read and written, or stored; 0: unknown
    BenchWork work = {};
    BenchError error = {};
    std::function<void()> run;
    bool is_parallel = false;            ///< uses other threads or processes, whose time only the wall clock sees
    Image picture = {}, error_map = {};  ///< for the page, 8 bits; empty if there is nothing to show
    double error_map_max = 0;            ///< the error at the map's brightest colour, in the error's unit
    std::optional<BenchSweep> sweep = {};
};

/// A method. Listing it costs nothing; `prepare` makes it ready. If the topic draws, `prepare` needs a context.
struct BenchMethod {
    std::string name;
    BenchKnobs knobs = {};  ///< its parameters: {"threads", "2"}
    std::function<BenchSubject()> prepare = {};
    bool peer = false;  ///< not from this course: another library, or commonly copied code
};

/// The size of pictures if the user names none, in pixels. With --quick, too.
inline constexpr glm::ivec2 usual_size{512, 512};

/// Methods that are compared with each other, in one panel of the topic's plot.
struct BenchScene {
    BenchKnobs knobs = {};  ///< the parameters that the methods share: {"map", "bricks"}
    std::string item;       ///< "texel", "triangle": times are in nanoseconds per item. For sweeps: the swept quantity
    std::vector<BenchMethod> methods = {};
};

struct BenchSettings {
    int repeats = 15;                     ///< samples per method; 0: measure only work and error
    bool quick = false;                   ///< few scenes and small sizes, for a first look
    std::optional<glm::ivec2> size = {};  ///< of the pictures that are timed, in pixels
    bool is_chosen = false;               ///< the user names values, of which none may be missing
    bool pictures = false;                ///< also make pictures and error maps for the page

    /// Returns `size`, or 512 x 512, 256 x 256 with `quick`.
    glm::ivec2 frame_size() const { return size.value_or(glm::ivec2(quick ? 256 : 512)); }
    /// Returns whether a person waits for a whole topic, which then takes under 20 s of processor time, with fewer
    /// scenes and methods than the baseline has.
    bool is_first_look() const { return quick && repeats > 0 && !is_chosen; }
};

struct BenchTopic {
    std::string name, help;
    std::string question;  ///< the question that its measurements answer, for its page
    std::function<std::vector<BenchScene>(const BenchSettings&)> scenes;
    bool draws = false;                  ///< its methods need a context, from `prepare` to their destructors
    bool only_time = false;              ///< has no work and no errors
    bool sweeps = false;                 ///< has no times: each subject has a `sweep`
    std::vector<std::string> labs = {};  ///< two digits each: the labs to which it belongs, if they are few
};
/// Returns all topics: those of labs by their first lab, then the others by name.
const std::vector<BenchTopic>& bench_topics();

/// Adds a topic; each file with a topic defines an object of this type.
struct TopicRegistration {
    explicit TopicRegistration(BenchTopic topic);
};

/// Keeps the methods that match all of `wanted`. Each entry is a knob of a scene or a method with the wanted values, or
/// "method" with names of methods. Throws UsageError, which lists the choices, if no scene of the topic has the knob or
/// the value.
std::vector<BenchScene> filter_scenes(const BenchTopic& topic, std::vector<BenchScene> scenes,
                                      std::span<const std::pair<std::string, std::vector<std::string>>> wanted);

/// Returns a text such as "a=1 b=2".
std::string knob_text(const BenchKnobs& knobs);

/// A method's times, in nanoseconds per item.
struct BenchTimes {
    double median = 0, p10 = 0, p90 = 0;
};

/// Returns the quantile of a sample, with linear interpolation; `share` is in [0, 1]. Precondition: the sample is not
/// empty.
double quantile(std::vector<double> values, double share);

/// Returns the mean, 99th percentile and maximum of a sample of errors; all zero if it is empty.
BenchError error_figures(std::vector<double> errors, std::string unit);

/// Returns the seconds that `times` runs of a subject take.
using BenchClock = std::function<double(const BenchSubject& subject, size_t times)>;
/// Uses the wall clock. Precondition: a run has finished its work when it returns.
double by_wall_clock(const std::function<void()>& run, size_t times);
/// Uses the processor time of the calling thread: the time of other programs does not count. Precondition: a run does
/// its work in the calling thread.
double by_cpu_clock(const std::function<void()>& run, size_t times);

/// Times several subjects in turns. Each round takes one sample of every subject, in a new order, so that other load on
/// the machine affects all of them alike. Runs shorter than a millisecond are repeated within a sample.
class BenchTurns {
public:
    /// Runs each subject twice to warm up. Calls `begin` with the subject's index before each run. Rethrows exceptions
    /// of a run.
    BenchTurns(std::span<const BenchSubject> subjects, BenchClock clock, std::function<void(size_t)> begin = {});
    void round();
    /// Precondition: at least one round.
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

/// Returns which points are on the Pareto front. `points` are pairs of time and error. A point is on the front if no
/// other point is at least as good in both and better in one. Equal points are on it together.
std::vector<bool> pareto_front(std::span<const std::pair<double, double>> points);

}  // namespace relief::measure
