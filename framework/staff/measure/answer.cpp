#include "framework/staff/measure/answer.h"

#include <fmt/format.h>

#include <algorithm>

#include "framework/core/base/text.h"
#include "framework/staff/measure/plot.h"
#include "framework/staff/measure/sweep.h"

namespace relief::measure {
namespace {

std::string time_text(double nanoseconds) {
    if (nanoseconds >= 1e9) return rounded(nanoseconds * 1e-9) + " s";
    if (nanoseconds >= 1e6) return rounded(nanoseconds * 1e-6) + " ms";
    if (nanoseconds >= 1e3) return rounded(nanoseconds * 1e-3) + " µs";
    return rounded(nanoseconds) + " ns";
}

std::string with_figures(const BenchRow& row) {
    return fmt::format("{} ({}, mean error {})", short_name(row), time_text(row.times.median),
                       amount_of(row.error.mean, row.error.unit));
}

std::string of_times(std::span<const BenchRow> rows, std::vector<size_t> timed) {
    std::sort(timed.begin(), timed.end(),
              [&](size_t a, size_t b) { return rows[a].times.median < rows[b].times.median; });
    const BenchRow &first = rows[timed.front()], &last = rows[timed.back()];
    if (timed.size() == 1)
        return fmt::format("{} takes {} a {}.", short_name(first), time_text(first.times.median), first.item);
    return fmt::format("Fastest: {} ({} a {}). Slowest: {} ({}), {} times that.", short_name(first),
                       time_text(first.times.median), first.item, short_name(last), time_text(last.times.median),
                       rounded(last.times.median / first.times.median, 2));
}

std::string of_sweeps(std::span<const BenchRow> rows, const std::vector<size_t>& scene) {
    std::vector<std::string> ours, peers;
    size_t count = 0;
    for (const size_t place : scene) {
        const BenchRow& row = rows[place];
        if (!row.sweep) continue;
        ++count;
        const auto& places = row.sweep->places;
        if (std::all_of(places.begin(), places.end(), [&](const auto& one) { return holds(*row.sweep, one); }))
            (row.peer ? peers : ours).push_back(short_name(row));
    }
    ours.insert(ours.end(), peers.begin(), peers.end());
    return ours.empty() ? fmt::format("None of the {} methods keeps its stated error for all inputs.", count)
                        : fmt::format("{} of {} methods {} the stated error for all inputs: {}.", ours.size(), count,
                                      ours.size() == 1 ? "keeps" : "keep", join(ours, ", "));
}

std::vector<size_t> timed_of(std::span<const BenchRow> rows, const std::vector<size_t>& scene) {
    std::vector<size_t> timed;
    for (const size_t place : scene)
        if (rows[place].is_measured() && rows[place].repeats > 0) timed.push_back(place);
    return timed;
}

}  // namespace

std::vector<size_t> chief_scene(std::span<const BenchRow> rows) {
    std::vector<size_t> best;
    std::pair<bool, size_t> best_rank{false, 0};
    for (const std::vector<size_t>& scene : scenes_of(rows)) {
        size_t measured = 0;
        for (const size_t place : scene) measured += rows[place].is_measured();
        const std::pair rank{!front_of(rows, scene).empty(), measured};
        if (rank <= best_rank) continue;
        best = scene, best_rank = rank;
    }
    return best;
}

std::string answer_of(std::span<const BenchRow> rows, const std::vector<size_t>& scene) {
    if (std::any_of(scene.begin(), scene.end(), [&](size_t place) { return rows[place].sweep.has_value(); }))
        return of_sweeps(rows, scene);
    const std::vector<size_t> timed = timed_of(rows, scene);
    if (timed.empty()) return {};
    std::vector<size_t> front = front_of(rows, scene);
    if (front.empty()) return of_times(rows, timed);
    std::sort(front.begin(), front.end(),
              [&](size_t a, size_t b) { return rows[a].times.median < rows[b].times.median; });
    const BenchRow &fast = rows[front.front()], &accurate = rows[front.back()];
    if (front.size() == 1)
        return fmt::format("Of {} methods {} is the fastest and the most accurate.", timed.size(), with_figures(fast));
    return fmt::format(
        "Of {} methods {} are beaten by no other in both time and error. The fastest: {}. The most accurate: {}, {} "
        "times "
        "as long.",
        timed.size(), front.size(), with_figures(fast), with_figures(accurate),
        rounded(accurate.times.median / fast.times.median, 2));
}

}  // namespace relief::measure
