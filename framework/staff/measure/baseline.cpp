#include "framework/staff/measure/baseline.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "framework/core/base/text.h"

namespace relief::measure {
namespace {

/// Returns the figures that must not grow, by name.
std::map<std::string, double> figures_of(const BenchRow& row) {
    std::map<std::string, double> figures(row.work.begin(), row.work.end());
    if (!row.error.unit.empty())
        figures["mean error"] = row.error.mean, figures["99th percentile of the error"] = row.error.p99;
    if (row.error.wrong) figures["share of wrong pixels"] = *row.error.wrong;
    return figures;
}

}  // namespace

BaselineReport compare_with_baseline(std::span<const BenchRow> now, std::span<const BenchRow> baseline,
                                     double tolerance) {
    // Smaller figures are rounding: errors are in texels, pixels, degrees and metres, and work is in whole units.
    constexpr double nothing = 1e-5;
    std::map<std::string, const BenchRow*> before;
    for (const BenchRow& row : baseline) before[row_name(row)] = &row;
    BaselineReport report;
    for (const BenchRow& row : now) {
        const std::string name = row_name(row);
        if (!row.is_measured()) {
            report.worse.push_back(name + ": " + row.state);
            before.erase(name);
            continue;
        }
        const auto known = before.find(name);
        if (known == before.end()) {
            report.worse.push_back(name + ": not in the baseline");
            continue;
        }
        const auto was = figures_of(*known->second), is = figures_of(row);
        before.erase(known);
        for (const auto& [figure, value] : is) {
            const auto old = was.find(figure);
            if (old == was.end()) {
                report.worse.push_back(fmt::format("{}: {} is not in the baseline", name, figure));
                continue;
            }
            const double slack = std::max(nothing, tolerance * old->second);
            const std::string line = fmt::format("{}: {} {}, was {}", name, figure, plain(value), plain(old->second));
            if (!(value <= old->second + slack)) report.worse.push_back(line);
            if (value < old->second - slack) report.better.push_back(line);
        }
        for (const auto& [figure, value] : was)
            if (!is.contains(figure))
                report.worse.push_back(fmt::format("{}: {} is not counted any more", name, figure));
    }
    for (const auto& [name, row] : before) report.worse.push_back(name + ": is in the baseline and not measured");
    return report;
}

}  // namespace relief::measure
