#include "framework/course/check/comparison.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "framework/core/base/error.h"
#include "framework/core/base/text.h"
#include "framework/core/image/compare.h"

namespace relief::check {
namespace {

/// Limits for pictures. In a trial they caught all of 26 visible one-line mistakes, and accepted one driver's noise.
constexpr double small_difference = 2.0 / 255 + 1e-6, large_difference = 32.0 / 255 + 1e-6;
constexpr double share_over_small = 0.0005;
constexpr size_t pixels_over_large = 4;

/// Allowed deviation of a vector's length from 1. Rounding to 8 bits costs 0.007; the mean of neighbours costs more.
constexpr double unit_tolerance = 0.05;

/// The measured values with their limits, and whether all limits were kept.
class Findings {
public:
    void add(const char* what, double value, std::optional<double> limit, const std::string& unit) {
        if (limit)
            add(value, *limit, [&](int digits) { return fmt::format("{} {}", what, amount_of(value, unit, digits)); });
    }
    /// Adds the share of pixels for which `what` is true, such as "are too dark".
    void add_share(const std::string& what, double share, std::optional<double> limit) {
        const double percent = 100 * share;
        if (limit)
            add(percent, 100 * *limit,
                [&](int digits) { return fmt::format("{} % of the pixels {}", rounded(percent, digits), what); });
    }
    /// Adds a value with a text that says it.
    void add_text(const std::string& text, double value, double limit) {
        add(value, limit, [&](int) { return text; });
    }
    /// Applies a lower bound to the value that was added last.
    void must_reach(double value, std::optional<double> min) {
        if (!min) return;
        use(*min, value);
        if (value >= *min) return;
        good_ = false;
        text_ += fmt::format(" (at least {})", rounded(*min, digits_for(value, *min)));
    }
    Verdict judgement() const {
        return {.outcome = good_ ? Outcome::passed : Outcome::wrong, .found = text_, .used = used_};
    }

private:
    /// Returns three, or as many digits as distinguish a value from its limit, at most nine.
    static int digits_for(double value, double limit) {
        int digits = 3;
        while (digits < 9 && value != limit && rounded(value, digits) == rounded(limit, digits)) ++digits;
        return digits;
    }
    void add(double value, double limit, const std::function<std::string(int digits)>& text) {
        const bool kept = value <= limit;
        good_ &= kept;
        use(value, limit);
        const int digits = digits_for(value, limit);
        text_ += fmt::format("{}{}{}", text_.empty() ? "" : ", ", text(digits),
                             kept ? "" : fmt::format(" (at most {})", rounded(limit, digits)));
    }
    void use(double part, double whole) {
        if (part > 0) used_ = std::max(used_, part / whole);
    }
    bool good_ = true;
    double used_ = 0;
    std::string text_;
};

bool is_surface(const Image& image, size_t pixel) { return image.values[pixel * image.channels] != no_surface; }

/// Returns the share of pixels in which `expected` has unit length and `drawn` does not. The angle between two
/// directions does not show this mistake.
double share_not_unit(const Image& drawn, const Image& expected) {
    const auto length = [](const Image& image, size_t pixel) {
        const float* const v = &image.values[pixel * size_t(image.channels)];
        return std::sqrt(double(v[0]) * double(v[0]) + double(v[1]) * double(v[1]) + double(v[2]) * double(v[2]));
    };
    size_t count = 0;
    for (size_t i = 0; i < drawn.pixel_count(); ++i)
        if (is_surface(drawn, i) && is_surface(expected, i) && std::abs(length(expected, i) - 1) < unit_tolerance)
            count += !(std::abs(length(drawn, i) - 1) < unit_tolerance);
    return double(count) / double(drawn.pixel_count());
}

Verdict compare_probes(const CheckInfo& check, const ProbeInfo& probe, const Image& drawn, const Image& expected) {
    size_t off = 0;
    const size_t only_one = one_sided(drawn, expected).count();
    const Image error = error_image(drawn, expected, probe.error);
    const ErrorSummary summary = summarize(error);
    if (summary.count == 0) return {Outcome::broken, nothing_to_compare(drawn, expected, summary)};
    for (const float value : error.values) off += value > 1 && value != no_surface;
    Findings findings;
    std::string look_at;
    const Limits& limits = check.limits;
    findings.add("mean", summary.mean, limits.mean, probe.unit);
    findings.must_reach(summary.mean, limits.at_least);
    findings.add("99 % within", summary.p99, limits.p99, probe.unit);
    findings.add("largest", summary.largest, limits.largest, probe.unit);
    findings.add_share("are off by more than " + amount_of(1, probe.unit), double(off) / double(summary.count),
                       limits.wrong);
    if (double(only_one) > limits.outline * double(drawn.pixel_count()))
        findings.add_share("show a surface in only one picture", double(only_one) / double(drawn.pixel_count()),
                           limits.outline);
    if (probe.error == ErrorMetric::angle && !probe.any_length && check.against == "truth")
        if (const double share = share_not_unit(drawn, expected); share > limits.outline) {
            if (findings.judgement().outcome == Outcome::passed)
                look_at = "the directions are right, but their length is not 1: normalise the vector that you return";
            findings.add_share("have a vector whose length is not 1", share, limits.outline);
        }
    if (summary.not_finite > 0)
        return {Outcome::wrong, fmt::format("{} pixels are not a number or have no direction", summary.not_finite)};
    Verdict said = findings.judgement();
    said.look_at = look_at;
    return said;
}

Verdict compare_pictures(const Image& drawn, const Image& expected) {
    const double pixels = double(drawn.pixel_count());
    Findings findings;
    findings.add_share("are off by more than 2/255",
                       double(difference(drawn, expected, small_difference).pixels_over) / pixels, share_over_small);
    const size_t many = difference(drawn, expected, large_difference).pixels_over;
    findings.add_text((many == 0   ? "none"
                       : many == 1 ? "1 pixel"
                                   : fmt::format("{} pixels", many)) +
                          " by more than 32/255",
                      double(many), double(pixels_over_large));
    return findings.judgement();
}

/// Returns the value of a call as text: "0.5", "(0, 1, 0)". A call has up to four components; those that are 0 in both
/// values are left out at the end.
std::string text_of_call(const float* value, const float* other) {
    int count = 4;
    while (count > 1 && value[count - 1] == 0 && other[count - 1] == 0) --count;
    std::string text;
    for (int i = 0; i < count; ++i) text += (i > 0 ? ", " : "") + rounded(double(value[i]), 6);
    return count > 1 ? "(" + text + ")" : text;
}

/// Judges the values of a task's calls. `look_at` quotes the words of the task whose calls fail.
Verdict compare_calls(const Manifest& manifest, const CheckInfo& check, const Image& drawn, const Image& expected) {
    Verdict said{.outcome = Outcome::passed};
    size_t call = 0, wrong = 0;
    std::vector<std::string> broken;  // demands
    std::string first;
    for (const ExampleInfo& example : manifest.examples) {
        if (example.task != check.task || example.hidden != check.hidden) continue;
        bool holds = true;
        for (size_t i = 0; i < example.calls.size(); ++i, ++call) {
            const float *const value = &drawn.values[4 * call], *const right = &expected.values[4 * call];
            double used = 0;
            for (int channel = 0; channel < 4; ++channel) {
                const double error = std::abs(double(value[channel]) - double(right[channel])) /
                                     (example.within * std::max(1.0, std::abs(double(right[channel]))));
                used = std::max(used, std::isfinite(error) ? error : 1e30);
            }
            said.used = std::max(said.used, used);
            wrong += used > 1;
            holds &= used <= 1;
            if (used > 1 && first.empty())
                first = fmt::format("{} is {}, not {}", example.calls[i], text_of_call(value, right),
                                    text_of_call(right, value));
        }
        if (!holds) broken.push_back(example.asks);
    }
    said.found = fmt::format("{} of {} calls return something else", wrong, call);
    if (wrong == 0) return said;
    said.outcome = Outcome::wrong;
    said.found += ": " + first;
    // Not "this demand is broken": a call can fail through another demand than its own.
    said.look_at =
        broken.size() == 1 ? "a call for these words of the task fails: " : "calls for these words of the task fail: ";
    said.look_at += fmt::format("\"{}\"", fmt::join(broken, "\"; \""));
    return said;
}

/// Returns whether a value counts the rounds after which Mesa's llvmpipe leaves a loop (lp_bld_limits.h:
/// LP_MAX_TGSI_LOOP_ITERATIONS, 65,535), and the expected one does not.
bool has_rounds_of_an_endless_loop(const Image& drawn, const Image& expected) {
    for (size_t i = 0; i < drawn.values.size(); ++i)
        if (std::abs(std::abs(drawn.values[i]) - 65536) <= 1 && !(std::abs(drawn.values[i] - expected.values[i]) <= 1))
            return true;
    return false;
}

Verdict compare(const Manifest& manifest, const CheckInfo& check, const Image& drawn, const Image& expected) {
    if (check.shot.calls && drawn.same_shape(expected)) return compare_calls(manifest, check, drawn, expected);
    try {
        refuse_unusable(drawn, check.shot);
    } catch (const Error& error) {
        return {Outcome::broken, error.what()};
    }
    if (!drawn.same_shape(expected)) return {Outcome::broken, "the expected picture has another size"};
    if (!check.shot.probe) return compare_pictures(drawn, expected);
    return compare_probes(check, manifest.probe(check.shot.probe.name), drawn, expected);
}

}  // namespace

Verdict judge(const Manifest& manifest, const CheckInfo& check, const Image& drawn, const Image& expected) {
    Verdict said = compare(manifest, check, drawn, expected);
    if (said.outcome == Outcome::wrong && drawn.same_shape(expected) && has_rounds_of_an_endless_loop(drawn, expected))
        said.look_at = "a loop does not end: the software renderer leaves it after 65,536 rounds";
    return said;
}

}  // namespace relief::check
