#include "framework/staff/measure/bench.h"

#include <fmt/format.h>

#include <time.h>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <random>
#include <set>

#include "framework/core/base/error.h"
#include "framework/core/base/text.h"

namespace relief::measure {
namespace {

/// Returns the value of a knob of a scene or a method; null if it has no such knob.
const std::string* value_of(const BenchKnobs& knobs, const std::string& name) {
    for (const auto& [knob, value] : knobs)
        if (knob == name) return &value;
    return nullptr;
}

const std::string* value_of(const BenchScene& scene, const BenchMethod& method, const std::string& name) {
    if (name == "method") return &method.name;
    const std::string* const value = value_of(method.knobs, name);
    return value ? value : value_of(scene.knobs, name);
}

/// Returns a topic's knobs with all their values, in order of appearance.
std::vector<std::pair<std::string, std::vector<std::string>>> sweep_of(const std::vector<BenchScene>& scenes) {
    std::vector<std::pair<std::string, std::vector<std::string>>> sweep = {{"method", {}}};
    const auto add = [&](const std::string& knob, const std::string& value) {
        auto place = std::find_if(sweep.begin(), sweep.end(), [&](const auto& one) { return one.first == knob; });
        if (place == sweep.end()) place = sweep.insert(place, {knob, {}});
        if (std::find(place->second.begin(), place->second.end(), value) == place->second.end())
            place->second.push_back(value);
    };
    for (const BenchScene& scene : scenes) {
        for (const auto& [knob, value] : scene.knobs) add(knob, value);
        for (const BenchMethod& method : scene.methods) {
            add("method", method.name);
            for (const auto& [knob, value] : method.knobs) add(knob, value);
        }
    }
    return sweep;
}

}  // namespace

std::string knob_text(const BenchKnobs& knobs) {
    std::string text;
    for (const auto& [name, value] : knobs) text += fmt::format("{}{}={}", text.empty() ? "" : " ", name, value);
    return text;
}

std::vector<BenchScene> filter_scenes(const BenchTopic& topic, std::vector<BenchScene> scenes,
                                      std::span<const std::pair<std::string, std::vector<std::string>>> wanted) {
    const auto sweep = sweep_of(scenes);
    std::vector<std::string> names;
    for (const auto& [knob, values] : sweep) names.push_back(knob);
    for (const auto& one : wanted) {
        const std::string& knob = one.first;  // not a structured binding: clang 14 cannot capture one in a lambda
        const std::vector<std::string>& values = one.second;
        const auto known = std::find(names.begin(), names.end(), knob);
        if (known == names.end())
            throw UsageError(topic.name + " does not sweep this: " + unknown("knob", knob, names));
        const std::vector<std::string>& possible = sweep[size_t(known - names.begin())].second;
        for (const std::string& value : values)
            if (std::find(possible.begin(), possible.end(), value) == possible.end())
                throw UsageError(fmt::format("{} does not measure {} = '{}': choose from {}", topic.name, knob, value,
                                             join(possible, ", ")));
        for (BenchScene& scene : scenes)
            std::erase_if(scene.methods, [&](const BenchMethod& method) {
                const std::string* const value = value_of(scene, method, knob);
                return !value || std::find(values.begin(), values.end(), *value) == values.end();
            });
    }
    std::erase_if(scenes, [](const BenchScene& scene) { return scene.methods.empty(); });
    if (scenes.empty()) throw UsageError(topic.name + " has no method with all of these values");
    return scenes;
}

double quantile(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    const double place = share * double(values.size() - 1);
    const size_t below = size_t(place), above = std::min(below + 1, values.size() - 1);
    return values[below] + (place - double(below)) * (values[above] - values[below]);
}

BenchError error_figures(std::vector<double> errors, std::string unit) {
    BenchError error{.unit = std::move(unit)};
    if (errors.empty()) return error;
    error.mean = std::accumulate(errors.begin(), errors.end(), 0.0) / double(errors.size());
    error.largest = *std::max_element(errors.begin(), errors.end());
    error.p99 = quantile(std::move(errors), 0.99);
    return error;
}

double by_wall_clock(const std::function<void()>& run, size_t times) {
    const auto begin = std::chrono::steady_clock::now();
    for (size_t i = 0; i < times; ++i) run();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

double by_cpu_clock(const std::function<void()>& run, size_t times) {
    const auto now = [] {
        timespec used{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
        return double(used.tv_sec) + 1e-9 * double(used.tv_nsec);
    };
    const double begin = now();
    for (size_t i = 0; i < times; ++i) run();
    return now() - begin;
}

BenchTurns::BenchTurns(std::span<const BenchSubject> subjects, BenchClock clock, std::function<void(size_t)> begin)
    : subjects_(subjects),
      clock_(std::move(clock)),
      begin_(std::move(begin)),
      order_(subjects.size()),
      runs_(subjects.size(), 1),
      samples_(subjects.size()) {
    constexpr double shortest_sample = 1e-3;
    std::iota(order_.begin(), order_.end(), size_t{0});
    for (size_t i = 0; i < subjects.size(); ++i) {
        take(i, 1);  // warms up page faults, caches, and a library's first call
        const double once = take(i, 1);
        if (once < shortest_sample) runs_[i] = size_t(std::min(1e6, shortest_sample / std::max(once, 1e-9))) + 1;
    }
}

double BenchTurns::take(size_t subject, size_t times) {
    if (begin_) begin_(subject);
    return clock_(subjects_[subject], times);
}

void BenchTurns::round() {
    std::shuffle(order_.begin(), order_.end(), std::mt19937(seed_++));
    for (const size_t i : order_)
        samples_[i].push_back(take(i, runs_[i]) * 1e9 / double(runs_[i] * subjects_[i].items));
}

std::vector<BenchTimes> BenchTurns::times() const {
    std::vector<BenchTimes> times;
    for (const std::vector<double>& sample : samples_)
        times.push_back({quantile(sample, 0.5), quantile(sample, 0.1), quantile(sample, 0.9)});
    return times;
}

std::vector<bool> pareto_front(std::span<const std::pair<double, double>> points) {
    std::vector<bool> front;
    for (const auto& [x, y] : points)
        front.push_back(std::none_of(points.begin(), points.end(), [&, x = x, y = y](const auto& other) {
            return other.first <= x && other.second <= y && (other.first < x || other.second < y);
        }));
    return front;
}

}  // namespace relief::measure
