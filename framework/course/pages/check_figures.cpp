#include "framework/course/pages/check_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "framework/core/base/text.h"
#include "framework/course/pages/figures.h"
#include "framework/course/pages/page.h"
#include "framework/library/maps/visualize.h"

namespace relief::pages {
namespace {

/// Lower bound of the difference that gets the last colour of a map of pictures: eight times picture_step, the allowed
/// difference of a pixel.
constexpr double picture_scale = 16.0 / 255, picture_step = 2.0 / 255;

const char* sign_of(check::Outcome outcome) {
    switch (outcome) {
        case check::Outcome::passed:
            return "✓";
        case check::Outcome::wrong:
            return "✗";
        case check::Outcome::unfinished:
        case check::Outcome::unproven:
        case check::Outcome::waiting:
            return "…";
        case check::Outcome::machine:
            return "?";
        default:
            return "!";
    }
}

std::string how_to_read(const ProbeInfo& probe) {
    switch (probe.error) {
        case ErrorMetric::angle:
            return "x, y and z of a direction are red, green and blue; half of each means 0.";
        case ErrorMetric::distance:
            return probe.is_signed
                       ? "Each channel is grey at 0, brighter above it and darker below it, alike in both pictures."
                       : "Each channel goes from dark at its lowest value in either picture to bright at its highest.";
        case ErrorMetric::absolute:
            return probe.is_signed
                       ? "Black is 0, yellow the largest value in either picture; below 0, pale cyan stands "
                         "for as much."
                       : "Dark is 0, bright is the largest value in either picture.";
    }
    return {};
}

std::string expected_caption(const CheckInfo& check) {
    if (check.against == "truth") return "expected: the exact values";
    if (check.against == "solution") return "expected: the solution";
    return "expected: the same as in “" + check.against + "”";
}

}  // namespace

std::string outcome_words(check::Outcome outcome) {
    if (outcome == check::Outcome::machine) return "not graded";
    std::string words = check::name_of(outcome);
    std::replace(words.begin(), words.end(), '_', ' ');
    return words;
}

Fields badge(check::Outcome outcome, size_t count) {
    return {{"outcome", check::name_of(outcome)},
            {"sign", sign_of(outcome)},
            {"count", count > 0 ? std::to_string(count) : ""},
            {"words", outcome_words(outcome)}};
}

ComparedImages compare_images(const ProbeInfo* probe, const Image& drawn, const Image& expected, double allowed) {
    if (!drawn.same_shape(expected) || drawn.pixel_count() == 0) {
        const auto show = [&](const Image& image) {
            return image.pixel_count() == 0 ? Image()
                   : probe                  ? visualize_probe(image, probe->colors())
                                            : visualize_picture(image);
        };
        return {show(drawn), show(expected), {}, {}, {}, {}};
    }
    ComparedImages shown;
    std::tie(shown.drawn, shown.expected) = probe ? visualize_probes(drawn, expected, probe->colors())
                                                  : std::pair(visualize_picture(drawn), visualize_picture(expected));
    Image error = error_image(drawn, expected, probe ? probe->error : ErrorMetric::distance);
    const ErrorSummary summary = summarize(error);
    double largest = std::max<double>(summary.p99, probe ? allowed : picture_scale);
    if (largest <= 0) largest = summary.largest;  // if less than 1 % of the pixels differ
    if (!(largest > 0) || !std::isfinite(largest)) largest = 1;
    const double visible = probe ? allowed : picture_step;
    shown.differs = fmt::format("{} of {} pixels are off by more than {}; the mean is {}, the largest {}",
                                std::count_if(error.values.begin(), error.values.end(),
                                              [&](float value) { return !(value <= visible) && value != no_surface; }),
                                error.pixel_count(), probe ? amount_of(visible, probe->unit) : "2/255",
                                probe ? amount_of(summary.mean, probe->unit) : rounded(summary.mean * 255) + "/255",
                                probe ? rounded(summary.largest) : rounded(summary.largest * 255) + "/255");
    mark_one_sided(error, drawn, expected, largest);
    if (const size_t count = one_sided(drawn, expected).count(); count > 0)
        shown.differs += fmt::format("; {} have a surface in one of the two only", count);
    shown.difference = visualize_error(error, largest);
    shown.largest = probe ? amount_of(largest, probe->unit) : fmt::format("{:.0f}/255", largest * 255);
    shown.scale = error_scale({"0", shown.largest});
    return shown;
}

double largest_limit(const Limits& limits) {
    return std::max(
        {limits.mean.value_or(0), limits.p99.value_or(0), limits.largest.value_or(0), limits.wrong ? 1.0 : 0.0});
}

Fields check_figures(const Manifest& manifest, const CheckInfo& check, const Image& drawn, const Image& expected,
                     DrawnBy who, const Image& related) {
    const ProbeInfo* const probe = check.shot.probe ? &manifest.probe(check.shot.probe.name) : nullptr;
    // The scale reaches at least the limit, so that the map of a passed check stays dark.
    const ComparedImages shown = compare_images(probe, drawn, expected, largest_limit(check.limits));
    const std::string whose = who == DrawnBy::reader ? "your" : "the submission's",
                      what = probe ? probe->name + " is" : "lab draws";
    List figures;
    const auto add = [&](const Image& image, const char* kind, const std::string& caption, const std::string& alt,
                         Value scale = {}) {
        if (image.pixel_count() > 0)
            figures.push_back(figure(image, picture_uri(image), kind, caption, alt, std::move(scale)));
    };
    add(shown.drawn, "mine", who == DrawnBy::reader ? "yours" : "submitted",
        fmt::format("What {} {} for the check: {}", whose, what, check.name));
    add(shown.expected, "expected", expected_caption(check), "What is expected of the check: " + check.name);
    if (related.pixel_count() > 0)
        add(compare_images(probe, related, expected).drawn, "related", "expected, with that change",
            "The expected picture, changed as the hint says, in the check: " + check.name);
    add(shown.difference, "difference", "where they differ",
        "Where they differ in the check: " + check.name + ". " + shown.differs, shown.scale);
    const bool is_explained = probe && expected.pixel_count() > 0;
    return {{"check", check.name},
            {"figures", std::move(figures)},
            {"probe", is_explained ? probe->name : ""},
            {"how_to_read", is_explained ? how_to_read(*probe) : ""}};
}

void tell_once(Fields& figures, std::set<std::string>& told) {
    const std::string probe = figures["probe"].text;
    if (!probe.empty() && !told.insert(probe).second) figures["probe"] = "";
}

}  // namespace relief::pages
