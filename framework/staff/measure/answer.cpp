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

/// What a run says about the times of two methods.
enum class Difference { different, about_equal, unknown };

/// Spreads from p10 to p90 that do not overlap are different. Overlapping ones are about equal if they are narrow and
/// their medians are within a factor of 2; otherwise the run cannot tell.
Difference difference_between(const BenchRow& one, const BenchRow& other) {
    const BenchTimes &a = one.times, &b = other.times;
    if (a.p10 > b.p90 || b.p10 > a.p90) return Difference::different;
    const bool is_near = a.median <= 2 * b.median && b.median <= 2 * a.median;
    return is_near && !one.is_wide() && !other.is_wide() ? Difference::about_equal : Difference::unknown;
}

std::string list_of(std::vector<std::string> names) {
    constexpr size_t most = 3;
    const size_t more = names.size() > most + 1 ? names.size() - most : 0;
    names.resize(names.size() - more);
    return join(names, ", ") + (more > 0 ? fmt::format(" and {} more", more) : "");
}

/// Returns " About as fast: linear 8 steps. Cannot be told apart from it in this run: linear 16 steps." for the other
/// methods that noise may have made slower than `fast`; "" if there is none.
std::string about_as_fast(std::span<const BenchRow> rows, const std::vector<size_t>& timed, const BenchRow& fast) {
    std::vector<std::string> equal, unknown;
    for (const size_t place : timed)
        if (&rows[place] != &fast)
            if (const Difference difference = difference_between(rows[place], fast);
                difference != Difference::different)
                (difference == Difference::unknown ? unknown : equal).push_back(short_name(rows[place]));
    return (equal.empty() ? "" : " About as fast: " + list_of(equal) + ".") +
           (unknown.empty() ? "" : " Cannot be told apart from it in this run: " + list_of(unknown) + ".");
}

/// Returns "1.7 times as long", "not clearly longer in this run", or that the run cannot tell.
std::string as_long(const BenchRow& slow, const BenchRow& fast) {
    switch (difference_between(slow, fast)) {
        case Difference::about_equal:
            return "not clearly longer in this run";
        case Difference::unknown:
            return "a time that cannot be told apart in this run";
        default:
            return rounded(slow.times.median / fast.times.median, 2) + " times as long";
    }
}

std::string of_times(std::span<const BenchRow> rows, std::vector<size_t> timed) {
    std::sort(timed.begin(), timed.end(),
              [&](size_t a, size_t b) { return rows[a].times.median < rows[b].times.median; });
    const BenchRow &first = rows[timed.front()], &last = rows[timed.back()];
    if (timed.size() == 1)
        return fmt::format("{} takes {} a {}.", short_name(first), time_text(first.times.median), first.item);
    const bool all_overlap = std::all_of(timed.begin(), timed.end(), [&](size_t place) {
        return difference_between(rows[place], first) != Difference::different &&
               difference_between(rows[place], last) != Difference::different;
    });
    if (all_overlap)
        return fmt::format("{}: {} to {} a {}.",
                           difference_between(first, last) == Difference::about_equal
                               ? fmt::format("All {} methods take about as long", timed.size())
                               : fmt::format("The times of {} methods cannot be told apart in this run", timed.size()),
                           time_text(first.times.median), time_text(last.times.median), first.item);
    return fmt::format("The fastest: {} ({} a {}).{} The slowest: {} ({}), {}.", short_name(first),
                       time_text(first.times.median), first.item, about_as_fast(rows, timed, first), short_name(last),
                       time_text(last.times.median), as_long(last, first));
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
        if (rows[place].is_timed()) timed.push_back(place);
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
    const BenchRow& fast = rows[front.front()];
    // The fastest of those that have the smallest error, as it is written.
    const BenchRow& accurate = rows[*std::find_if(front.begin(), front.end(), [&](size_t place) {
        return rounded(rows[place].error.mean, 2) == rounded(rows[front.back()].error.mean, 2);
    })];
    const std::string also = about_as_fast(rows, timed, fast);
    if (&accurate == &fast)
        return fmt::format("Of {} methods {} is the fastest and the most accurate.{}", timed.size(), with_figures(fast),
                           also);
    return fmt::format(
        "Of {} methods {} are beaten by no other in both time and error. The fastest: {}.{} The most accurate: {}, {}.",
        timed.size(), front.size(), with_figures(fast), also, with_figures(accurate), as_long(accurate, fast));
}

}  // namespace relief::measure
