#include "framework/pages/check_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "framework/base/text.h"
#include "framework/image/visualize.h"
#include "framework/pages/figures.h"
#include "framework/pages/page.h"

namespace relief {
namespace {

/// The smallest difference between pictures that gets the last colour of the map: eight times what a pixel may be off.
constexpr double picture_scale = 16.0 / 255;

const char* sign_of(Outcome outcome) {
    switch (outcome) {
        case Outcome::passed:
            return "✓";
        case Outcome::wrong:
            return "✗";
        case Outcome::unfinished:
            return "…";
        case Outcome::machine:
            return "?";
        default:
            return "!";
    }
}

std::string how_to_read(ErrorMetric metric) {
    switch (metric) {
        case ErrorMetric::angle:
            return "x, y and z of a direction are red, green and blue; half of each means 0.";
        case ErrorMetric::distance:
            return "Each channel goes from dark to bright again and again: compare the bands.";
        case ErrorMetric::absolute:
            return "Dark is 0, bright is the largest value in either picture.";
    }
    return {};
}

std::string expected_caption(const CheckInfo& check) {
    if (check.against == "truth") return "expected: the exact values";
    if (check.against == "solution") return "expected: the solution";
    return "expected: the same as in “" + check.against + "”";
}

std::string figure(const Image& picture, const std::string& caption, const std::string& alt, const char* kind,
                   const std::string& more = {}) {
    if (picture.pixel_count() == 0) return {};
    return fmt::format(
        R"(<figure class="{}"><img src="{}" width="{}" height="{}" alt="{}"><figcaption>{}</figcaption>{}</figure>
)",
        kind, picture_uri(picture), picture.width, picture.height, html(alt), html(caption), more);
}

constexpr const char* style = R"(
.quiet { color: var(--quiet); margin: 0 0 14px; font-size: 15px; }
.check { background: var(--card); border: 1px solid var(--line); border-radius: 12px; margin: 0 0 14px; padding: 0 22px; }
.check[open] { padding-bottom: 18px; }
.check summary { cursor: pointer; padding: 14px 0; display: flex; gap: 14px; align-items: baseline; justify-content: space-between; }
summary::-webkit-details-marker { display: none; }
.check summary :is(h3, h4) { font-size: 18px; margin: 0; display: inline; }
.check summary :is(h3, h4)::before { content: "▸"; display: inline-block; width: 1.2em; color: var(--quiet); }
.check[open] > summary :is(h3, h4)::before { content: "▾"; }
.check dl { display: grid; grid-template-columns: max-content 1fr; gap: 6px 18px; margin: 0 0 18px; }
.check dt { color: var(--quiet); } .check dd { margin: 0; overflow-wrap: anywhere; }
.pictures { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 300px), 1fr)); gap: 18px; margin: 0 0 10px; }
figure { margin: 0; max-width: 512px; position: relative; break-inside: avoid; }
figure img { display: block; width: 100%; height: auto; border-radius: 6px; image-rendering: pixelated; box-shadow: 0 0 0 1px var(--line); }
figcaption { color: var(--quiet); font-size: 15px; margin-top: 6px; }
.points { font-size: 26px; color: var(--text); } meter { width: min(100%, 320px); height: 18px; }
@media (max-width: 600px) { .check { padding: 0 14px; } .check dl { grid-template-columns: 1fr; gap: 0; } .check dd { margin-bottom: 8px; } }
@media print { .check { break-inside: avoid-page; } .pictures { grid-template-columns: 1fr 1fr 1fr; } }
)";

}  // namespace

const char* const badge_style = R"(
.badge { font-weight: 600; white-space: nowrap; }
.badge.passed { color: var(--good); } .badge.unfinished { color: var(--open); } .badge.machine { color: var(--accent); }
.badge:is(.wrong, .broken, .crashed, .out_of_time, .out_of_memory) { color: var(--bad); }
)";

std::string outcome_words(Outcome outcome) {
    if (outcome == Outcome::machine) return "not graded";
    std::string words = name_of(outcome);
    std::replace(words.begin(), words.end(), '_', ' ');
    return words;
}

std::string outcome_badge(Outcome outcome, size_t count) {
    return fmt::format(R"(<span class="badge {}"><span aria-hidden="true">{}</span> {}{}</span>)", name_of(outcome),
                       sign_of(outcome), count > 0 ? fmt::format("{} ", count) : "", outcome_words(outcome));
}

ComparedImages compare_images(const ProbeInfo* probe, const Image& drawn, const Image& expected, double allowed) {
    if (!drawn.same_shape(expected) || drawn.pixel_count() == 0) {
        const auto show = [&](const Image& image) {
            return image.pixel_count() == 0 ? Image()
                   : probe                  ? visualize_probe(image, probe->error)
                                            : visualize_picture(image);
        };
        return {show(drawn), show(expected), {}, {}, {}};
    }
    ComparedImages shown;
    std::tie(shown.drawn, shown.expected) = probe ? visualize_probes(drawn, expected, probe->error)
                                                  : std::pair(visualize_picture(drawn), visualize_picture(expected));
    const Image error = error_image(drawn, expected, probe ? probe->error : ErrorMetric::distance);
    const ErrorSummary summary = summarize(error);
    double largest = std::max<double>(summary.p99, probe ? allowed : picture_scale);
    if (largest <= 0) largest = summary.largest;  // where less than 1 % of the pixels differ
    if (!(largest > 0) || !std::isfinite(largest)) largest = 1;
    shown.difference = visualize_error(error, largest);
    shown.differs = fmt::format("{} of {} pixels differ; the mean is {}, the largest {}",
                                std::count_if(error.values.begin(), error.values.end(),
                                              [](float value) { return value != 0 && value != no_surface; }),
                                error.pixel_count(),
                                probe ? amount_of(summary.mean, probe->unit) : rounded(summary.mean * 255) + " 255ths",
                                rounded(probe ? summary.largest : summary.largest * 255));
    shown.scale =
        error_scale({"0", probe ? amount_of(largest, probe->unit) : fmt::format("{:.0f}/255", largest * 255)});
    return shown;
}

std::string check_figures(const Manifest& manifest, const CheckInfo& check, const Image& drawn, const Image& expected,
                          DrawnBy who) {
    const ProbeInfo* const probe = check.shot.probe ? &manifest.probe(check.shot.probe.name) : nullptr;
    // The limit is on the scale: what passes stays dark, however small its own differences are.
    const Limits& limits = check.limits;
    const double allowed = std::max(
        {limits.mean.value_or(0), limits.p99.value_or(0), limits.largest.value_or(0), limits.wrong ? 1.0 : 0.0});
    const ComparedImages shown = compare_images(probe, drawn, expected, allowed);
    const std::string whose = who == DrawnBy::reader ? "your" : "the submission's",
                      what = probe ? probe->name + " is" : "lab draws";
    std::string text = fmt::format(R"(<div class="pictures" data-check="{}">)", html(check.name));
    text += figure(shown.drawn, who == DrawnBy::reader ? "yours" : "submitted",
                   fmt::format("What {} {} for the check: {}", whose, what, check.name), "mine");
    text += figure(shown.expected, expected_caption(check), "What is expected of the check: " + check.name, "expected");
    text += figure(shown.difference, "where they differ",
                   "Where they differ in the check: " + check.name + ". " + shown.differs, "difference", shown.scale);
    text += "</div>\n";
    if (probe && expected.pixel_count() > 0)
        text += fmt::format("<p class=\"quiet\">The pictures show “{}” as colours. {}</p>\n", html(probe->name),
                            how_to_read(probe->error));
    return text;
}

std::string check_style() { return badge_style + std::string(style) + figures_style(); }

std::string check_script() {
    return std::string(wipe_function) + R"(
for (const pictures of document.querySelectorAll(".pictures")) {
  const mine = pictures.querySelector(".mine img"), expected = pictures.querySelector(".expected img");
  if (!mine || !expected) continue;
  const words = "wipe to the expected picture", over = expected.cloneNode();
  over.alt = "";  // its words stand at the expected picture itself
  const {label} = wipe(mine, over, words, `${words}: ${pictures.dataset.check}`, 0, value => `${value} % expected`);
  pictures.querySelector(".mine").append(label);
}
)";
}

}  // namespace relief
