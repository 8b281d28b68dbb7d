#include "framework/course/check/agreement.h"

#include <algorithm>
#include <cmath>

namespace relief::check {
namespace {

/// An error in place of a picture counts as this number of values.
constexpr size_t error_weight = 1000;

/// Returns what the same code may differ by where another compiler rounds and orders its operations: a share of the
/// median of the finite values. Differences between drivers of llvmpipe were up to 1e-5 of it.
double rounding_of(const Sample& solution) {
    std::vector<float> sizes;
    for (const float value : solution.values)
        if (std::isfinite(value)) sizes.push_back(std::abs(value));
    if (sizes.empty()) return 0;
    const auto middle = sizes.begin() + std::ptrdiff_t(sizes.size() / 2);
    std::nth_element(sizes.begin(), middle, sizes.end());
    return 3e-5 * double(*middle);
}

}  // namespace

bool is_near(float a, float b, double tolerance) {
    if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
    return a == b || std::abs(double(a) - b) <= tolerance;
}

double tolerance_of(const Sample& mistake, const Sample& solution, bool is_probe, const Exactness& exactness) {
    if (!is_probe) return exactness.picture + 1e-6;
    double sum = 0;
    size_t count = 0;
    for (size_t i = 0; i < mistake.values.size(); ++i) {
        const double error = std::abs(double(mistake.values[i]) - solution.values[i]);
        if (!std::isfinite(error) || error == 0) continue;
        sum += error;
        ++count;
    }
    return count > 0 ? std::max(exactness.probe * sum / double(count), rounding_of(solution)) : 1e-6;
}

bool is_like(const Agreement& one, bool passed, const Exactness& exactness) {
    return one.differ == 0 ? passed : one.share() >= exactness.agreement;
}

void Agreement::add_kind(float value, double tolerance) {
    if (is_certain()) return;
    if (std::none_of(kinds.begin(), kinds.end(), [&](float kind) { return is_near(kind, value, tolerance); }))
        kinds.push_back(value);
}

void Agreement::add(const Agreement& other) {
    differ += other.differ, agree += other.agree;
    for (const float kind : other.kinds) add_kind(kind, 0);
}

std::string told(const std::string& hint, bool is_certain, size_t failed_checks) {
    const bool is_one_of_several = hint.find(" Or: ") != std::string::npos;
    return is_certain && failed_checks > 1 && !is_one_of_several ? hint : "Perhaps: " + hint;
}

Agreement agreement(const Sample& drawn, const Sample& mistake, const Sample& solution, bool is_probe,
                    const Exactness& exactness) {
    if (!drawn.is_drawn || !mistake.is_drawn) {
        const bool same = drawn.is_drawn == mistake.is_drawn && drawn.error == mistake.error;
        const size_t weight = std::min(error_weight, solution.values.size());
        return {.differ = weight, .agree = same ? weight : 0};
    }
    const double tolerance = tolerance_of(mistake, solution, is_probe, exactness);
    Agreement agreement;
    for (size_t i = 0; i < drawn.values.size(); ++i) {
        const float d = drawn.values[i], m = mistake.values[i], s = solution.values[i];
        if (is_near(d, s, tolerance) && is_near(m, s, tolerance)) continue;
        ++agreement.differ;
        if (!is_near(d, m, tolerance)) continue;
        ++agreement.agree;
        agreement.add_kind(m, tolerance);
    }
    return agreement;
}

}  // namespace relief::check
