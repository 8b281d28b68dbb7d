#include "framework/measure/bench.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numeric>
#include <random>

namespace relief {
namespace {

std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"') result += '"';
        result += c;
    }
    return result + '"';
}

std::string knob_text(const BenchMethod& method) {
    std::string text;
    for (const auto& [name, value] : method.knobs) text += fmt::format("{}{}={}", text.empty() ? "" : " ", name, value);
    return text;
}

/// A method's bytes in gigabytes a second; "" where it makes no claim of them.
std::string rate(const BenchMethod& method, const BenchTimes& times) {
    return method.bytes_per_item > 0 ? fmt::format("{:.1f}", method.bytes_per_item / times.median) : "";
}

}  // namespace

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

std::vector<BenchTimes> time_in_turns(std::span<const BenchMethod> methods, int repeats,
                                      const std::function<double()>& clock, const std::function<void()>& round) {
    constexpr double shortest_sample = 1e-3;
    std::vector<size_t> order(methods.size()), runs(methods.size());
    std::iota(order.begin(), order.end(), size_t{0});
    std::vector<std::vector<double>> samples(methods.size());
    for (size_t i = 0; i < methods.size(); ++i) {
        methods[i].run();  // page faults, caches, a library's first call
        const double begin = clock();
        methods[i].run();
        const double once = clock() - begin;
        runs[i] = once < shortest_sample ? size_t(std::min(1e6, shortest_sample / std::max(once, 1e-9))) + 1 : 1;
    }
    std::mt19937 random(1);
    for (int repeat = 0; repeat < repeats; ++repeat) {
        if (round) round();
        std::shuffle(order.begin(), order.end(), random);
        for (const size_t i : order) {
            const double begin = clock();
            for (size_t run = 0; run < runs[i]; ++run) methods[i].run();
            samples[i].push_back((clock() - begin) * 1e9 / double(runs[i] * methods[i].items));
        }
    }
    std::vector<BenchTimes> times;
    for (const std::vector<double>& sample : samples)
        times.push_back({quantile(sample, 0.5), quantile(sample, 0.1), quantile(sample, 0.9)});
    return times;
}

std::string cpu_name() {
    std::ifstream stream("/proc/cpuinfo");
    for (std::string line; std::getline(stream, line);)
        if (line.starts_with("model name"))
            if (const size_t colon = line.find(": "); colon != std::string::npos) return line.substr(colon + 2);
    return "unknown";
}

std::string bench_table(const BenchTopic& topic, std::span<const BenchMethod> methods,
                        std::span<const BenchTimes> times) {
    size_t name = 6, knobs = 5;
    std::string item = "item", unit = "unit";
    double longest = 0;
    bool any_wrong = false, any_work = false;
    for (const BenchTimes& time : times) longest = std::max(longest, time.median);
    const bool in_milliseconds = longest >= 1e6;  // one unit for a whole table
    const double scale = in_milliseconds ? 1e-6 : 1;
    for (const BenchMethod& method : methods) {
        name = std::max(name, method.name.size()), knobs = std::max(knobs, knob_text(method).size());
        item = method.item;
        any_wrong |= method.error.wrong.has_value(), any_work |= method.work.has_value();
        if (!method.error.unit.empty()) unit = method.error.unit;
    }
    std::string text = fmt::format("{}: {}\n{:<{}}  {:<{}}  {:>11} {:>9} {:>9} {:>7}  {:>10} {:>10} {:>10}{}{}\n",
                                   topic.name, topic.help, "method", name, "knobs", knobs,
                                   (in_milliseconds ? "ms/" : "ns/") + item, "p10", "p90", "GB/s", "mean " + unit,
                                   "p99", "largest", any_wrong ? "   wrong %" : "", any_work ? "      work" : "");
    for (size_t i = 0; i < methods.size(); ++i) {
        const BenchError& error = methods[i].error;
        text += fmt::format("{:<{}}  {:<{}}  {:>11.4g} {:>9.4g} {:>9.4g} {:>7}", methods[i].name, name,
                            knob_text(methods[i]), knobs, scale * times[i].median, scale * times[i].p10,
                            scale * times[i].p90, rate(methods[i], times[i]));
        if (!error.unit.empty())
            text += fmt::format("  {:>10.4g} {:>10.4g} {:>10.4g}", error.mean, error.p99, error.largest);
        if (error.wrong) text += fmt::format(" {:>9.4f}", *error.wrong * 100);
        if (methods[i].work) text += fmt::format(" {:>9.2f}", *methods[i].work);
        text += '\n';
    }
    return text;
}

std::string bench_csv(const BenchTopic& topic, std::span<const BenchMethod> methods, std::span<const BenchTimes> times,
                      const BenchSettings& settings, const BenchMachine& machine) {
    std::string text =
        "topic,method,knobs,items,item,repeats,ns_per_item_median,ns_per_item_p10,ns_per_item_p90,bytes_per_item,"
        "error_mean,error_p99,error_largest,error_unit,error_wrong,work_per_item,renderer,cpu,compiler,commit\r\n";
    for (size_t i = 0; i < methods.size(); ++i) {
        const BenchMethod& method = methods[i];
        const BenchError& error = method.error;
        // A peer without an error leaves its columns empty: 0 would be a claim.
        const std::string errors =
            error.unit.empty() ? ",,," : fmt::format("{},{},{},{}", error.mean, error.p99, error.largest, error.unit);
        const std::string bytes = method.bytes_per_item > 0 ? fmt::format("{}", method.bytes_per_item) : "";
        const auto or_empty = [](const std::optional<double>& value) { return value ? fmt::format("{}", *value) : ""; };
        text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\r\n", quoted(topic.name),
                            quoted(method.name), quoted(knob_text(method)), method.items, method.item, settings.repeats,
                            times[i].median, times[i].p10, times[i].p90, bytes, errors, or_empty(error.wrong),
                            or_empty(method.work), quoted(machine.renderer), quoted(machine.cpu),
                            quoted(machine.compiler), quoted(machine.commit));
    }
    return text;
}

}  // namespace relief
