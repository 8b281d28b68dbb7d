#include "framework/app/check_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "framework/app/page.h"
#include "framework/context/context.h"
#include "framework/image/visualize.h"

namespace relief {
namespace {

/// Where a difference between pictures has the last colour of the map: eight times what a pixel may be off.
constexpr double picture_scale = 16.0 / 255;

const char* sign_of(Outcome outcome) {
    constexpr const char* signs[] = {"✓", "✗", "…", "!"};
    return signs[int(outcome)];
}

std::string badge(Outcome outcome) {
    return fmt::format(R"(<span class="badge {0}"><span aria-hidden="true">{1}</span> {0}</span>)", name_of(outcome),
                       sign_of(outcome));
}

/// As one would type it to draw the check's shot; nothing when no option says where its camera looks.
std::string command_for(const LabEntry& lab, const Manifest& manifest, const Shot& shot) {
    Orbit camera = manifest.camera;
    camera.yaw = shot.camera.yaw, camera.pitch = shot.camera.pitch, camera.distance = shot.camera.distance;
    if (!(camera == shot.camera)) return {};
    std::string command = fmt::format("./relief shot {} --size {}x{}", lab.two_digits(), shot.size.x, shot.size.y);
    if (!(camera == manifest.camera))
        command += fmt::format(" --camera {},{},{}", camera.yaw, camera.pitch, camera.distance);
    if (shot.time != 0) command += fmt::format(" --time {}", shot.time);
    for (const auto& [knob, value] : shot.set) command += fmt::format(" --set {}={}", knob, value);
    if (shot.probe) command += " --probe " + shot.probe.name;
    return command + " -o mine.png";
}

/// Both probes in the same colours: bands and heat are chosen by what is in a picture, so they are one for a moment.
std::pair<Image, Image> visualize_both(const Image& drawn, const Image& expected, ErrorMetric metric) {
    Image both(drawn.width, 2 * drawn.height, drawn.channels);
    const auto middle = std::copy(drawn.values.begin(), drawn.values.end(), both.values.begin());
    std::copy(expected.values.begin(), expected.values.end(), middle);
    const Image picture = visualize_probe(both, metric);
    Image first(drawn.width, drawn.height, picture.channels, 8), second = first;
    const auto half = picture.values.begin() + std::ptrdiff_t(first.values.size());
    std::copy(picture.values.begin(), half, first.values.begin());
    std::copy(half, picture.values.end(), second.values.begin());
    return {first, second};
}

std::string how_to_read(ErrorMetric metric) {
    switch (metric) {
        case ErrorMetric::angle:
            return "A direction's x, y and z are red, green and blue, 0 being half of each.";
        case ErrorMetric::distance:
            return "Each channel rises from dark to bright again and again: compare the bands.";
        case ErrorMetric::absolute:
            return "From dark, 0, to bright, the largest value in either picture.";
    }
    return {};
}

class Page {
public:
    Page(const LabEntry& lab, const Manifest& manifest) : lab_(lab), manifest_(manifest) {}

    std::string text;

    void add(const TaskResult& task) {
        text +=
            fmt::format(R"(<section aria-labelledby="task-{0}"><h2 id="task-{0}"><span class="number">{0}</span>{1}</h2>
<p class="quiet">{2} of {3} points · <code>{4}</code></p>
)",
                        html(task.task->id), html(task.task->title), points_text(task.points()), task.task->points,
                        html(task.task->file));
        for (const CheckResult& result : task.checks) add(result);
        text += "</section>\n";
    }

private:
    void add(const CheckResult& result) {
        const CheckInfo& check = *result.check;
        const bool passed = result.outcome == Outcome::passed;
        text += fmt::format("<details class=\"check\"{}><summary><h3>{}</h3>{}</summary>\n<dl>", passed ? "" : " open",
                            html(check.name), badge(result.outcome));
        line(result.outcome == Outcome::broken ? "message" : "found", html(result.found));
        if (!check.reason.empty()) line("allowed", html(check.reason));
        if (!passed && result.outcome != Outcome::unfinished) line("look at", html(look_at(result)));
        const std::string command = command_for(lab_, manifest_, check.shot);
        if (!command.empty()) line("draw it", "<code>" + html(command) + "</code>");
        text += "</dl>\n";
        pictures(result);
        text += "</details>\n";
    }

    void line(const char* name, const std::string& value) {
        text += fmt::format("<dt>{}</dt><dd>{}</dd>", name, value);
    }

    void pictures(const CheckResult& result) {
        Image drawn = result.drawn, expected = result.expected;
        const bool both = drawn.same_shape(expected) && drawn.pixel_count() > 0;
        const ProbeInfo* const probe =
            result.check->shot.probe ? &manifest_.probe(result.check->shot.probe.name) : nullptr;
        if (probe && both)
            std::tie(drawn, expected) = visualize_both(drawn, expected, probe->error);
        else if (probe)
            for (Image* image : {&drawn, &expected})
                if (image->pixel_count() > 0) *image = visualize_probe(*image, probe->error);
        text += "<div class=\"pictures\">";
        figure(drawn, "yours", "What your " + subject(probe) + " for the check: " + result.check->name, "mine");
        figure(expected, expected_caption(*result.check), "What is expected of the check: " + result.check->name,
               "expected");
        if (both) difference_of(result, probe);
        text += "</div>\n";
        if (probe && expected.pixel_count() > 0)
            text += fmt::format("<p class=\"quiet\">The pictures show “{}” as colours. {}</p>\n", html(probe->name),
                                how_to_read(probe->error));
    }

    static std::string subject(const ProbeInfo* probe) { return probe ? probe->name + " is" : "lab draws"; }
    static std::string expected_caption(const CheckInfo& check) {
        if (check.against == "truth") return "expected: the truth";
        if (check.against == "solution") return "expected: the solution";
        return "expected: the same as in “" + check.against + "”";
    }

    void figure(const Image& picture, const std::string& caption, const std::string& alt, const char* kind,
                const std::string& more = {}) {
        if (picture.pixel_count() == 0) return;
        text += fmt::format(
            R"(<figure class="{}"><img src="{}" width="{}" height="{}" alt="{}"><figcaption>{}</figcaption>{}</figure>
)",
            kind, picture_uri(picture), picture.width, picture.height, html(alt), html(caption), more);
    }

    void difference_of(const CheckResult& result, const ProbeInfo* probe) {
        const Image error = error_image(result.drawn, result.expected, probe ? probe->error : ErrorMetric::distance);
        const ErrorSummary summary = summarize(error);
        const Limits& limits = result.check->limits;
        // The limit is on the scale too: what passes stays dark, however small its own differences are.
        const double allowed = std::max(
            {limits.mean.value_or(0), limits.p99.value_or(0), limits.largest.value_or(0), limits.wrong ? 1.0 : 0.0});
        double largest = probe ? std::max(summary.p99, allowed) : picture_scale;
        if (largest <= 0) largest = 1;
        const std::string end = probe ? fmt::format("{:.3g} {}", largest, probe->unit) : "16/255";
        const std::string scale = fmt::format(
            R"(<div class="scale" aria-hidden="true"><div></div><span>0</span><span>{} and more</span></div>)",
            html(end));
        const std::string alt = fmt::format(
            "Where they differ in the check: {}. {} of {} pixels do; the mean is {:.3g} {}, the largest {:.3g}",
            result.check->name,
            std::count_if(error.values.begin(), error.values.end(),
                          [](float value) { return value != 0 && value != no_surface; }),
            summary.count, probe ? summary.mean : summary.mean * 255, probe ? probe->unit : "255ths",
            probe ? summary.largest : summary.largest * 255);
        figure(visualize_error(error, largest), "where they differ", alt, "difference", scale);
    }

    const LabEntry& lab_;
    const Manifest& manifest_;
};

/// The colours of visualize_error(), which are linear in between.
std::string heat_gradient() {
    std::string stops;
    for (int i = 0; i <= 5; ++i) {
        const glm::dvec3 color = 255.0 * heat_color(i / 5.0);
        stops += fmt::format(", rgb({:.0f} {:.0f} {:.0f})", color.r, color.g, color.b);
    }
    return "linear-gradient(to right" + stops + ")";
}

constexpr const char* style = R"(
h3 { font-size: 18px; margin: 0; display: inline; }
section { margin: 0 0 44px; }
.quiet { color: var(--quiet); margin: 0 0 14px; font-size: 15px; }
.check { background: var(--card); border: 1px solid var(--line); border-radius: 12px; margin: 0 0 14px; padding: 0 22px; }
.check[open] { padding-bottom: 18px; }
summary { cursor: pointer; padding: 14px 0; display: flex; gap: 14px; align-items: baseline; justify-content: space-between; }
summary::-webkit-details-marker { display: none; }
summary h3::before { content: "▸"; display: inline-block; width: 1.2em; color: var(--quiet); }
[open] > summary h3::before { content: "▾"; }
.badge { font-weight: 600; white-space: nowrap; }
.passed { color: var(--good); } .wrong, .broken { color: var(--bad); } .unfinished { color: var(--open); }
dl { display: grid; grid-template-columns: max-content 1fr; gap: 6px 18px; margin: 0 0 18px; }
dt { color: var(--quiet); } dd { margin: 0; overflow-wrap: anywhere; }
.pictures { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 300px), 1fr)); gap: 18px; margin: 0 0 10px; }
figure { margin: 0; max-width: 512px; position: relative; }
figure img { display: block; width: 100%; height: auto; border-radius: 6px; image-rendering: pixelated; }
.laid { position: relative; } .laid img + img { position: absolute; inset: 0; }
figcaption { color: var(--quiet); font-size: 15px; margin-top: 6px; }
.scale { display: flex; flex-wrap: wrap; justify-content: space-between; font-size: 14px; color: var(--quiet); }
.scale div { flex: 0 0 100%; height: 10px; border-radius: 5px; border: 1px solid var(--line); margin: 4px 0; background: HEAT; }
label { display: flex; gap: 10px; align-items: center; font-size: 15px; color: var(--quiet); }
label span { white-space: nowrap; } label input { flex: 1; min-width: 0; accent-color: var(--accent); }
nav ul { list-style: none; margin: 18px 0 0; padding: 0; display: flex; flex-wrap: wrap; gap: 8px; }
nav a { display: block; background: var(--card); border: 1px solid var(--line); border-radius: 8px; padding: 6px 12px;
  color: var(--text); text-decoration: none; }
nav a:hover { border-color: var(--accent); }
.points { font-size: 26px; color: var(--text); } meter { width: min(100%, 320px); height: 18px; }
@media (max-width: 600px) { dl { grid-template-columns: 1fr; gap: 0; } dd { margin-bottom: 8px; } h1 { font-size: 32px; } }
)";

// Without it the page loses the sliders and nothing else.
constexpr const char* script = R"(<script>
for (const pictures of document.querySelectorAll(".pictures")) {
  const mine = pictures.querySelector(".mine img"), expected = pictures.querySelector(".expected img");
  if (!mine || !expected) continue;
  const laid = document.createElement("div"), over = expected.cloneNode(), label = document.createElement("label");
  laid.className = "laid";
  mine.replaceWith(laid);
  laid.append(mine, over);
  over.alt = "";
  label.innerHTML = '<span>wipe to the expected</span><input type="range" min="0" max="100" value="0">';
  const slider = label.querySelector("input");
  const slide = () => { over.style.clipPath = `inset(0 ${100 - slider.value}% 0 0)`; };
  slider.addEventListener("input", slide);
  slide();
  pictures.querySelector(".mine").append(label);
}
</script>
)";

Outcome worst(const TaskResult& task) {
    Outcome outcome = Outcome::passed;
    for (const CheckResult& result : task.checks) outcome = std::max(outcome, result.outcome);
    return outcome;
}

}  // namespace

std::string look_at(const CheckResult& result) {
    return result.outcome == Outcome::broken ? "what the message names; nothing is measured until the lab draws"
                                             : result.check->look_at;
}

std::string check_page(const LabEntry& lab, const Manifest& manifest, const std::vector<TaskResult>& tasks) {
    double points = 0;
    std::string contents;
    Page page(lab, manifest);
    for (const TaskResult& task : tasks) {
        points += task.points();
        contents += fmt::format(R"(<li><a href="#task-{0}">{0} {1}</a></li>)", html(task.task->id), badge(worst(task)));
        page.add(task);
    }
    std::string all_style = style;
    all_style.replace(all_style.find("HEAT"), 4, heat_gradient());
    return page_begin(fmt::format("Lab {}: {} of {} points", lab.two_digits(), points_text(points), manifest.points()),
                      all_style) +
           fmt::format(R"(<header><h1><span class="number">{0}</span> {1}</h1>
<p class="points">{2} of {3} points</p>
<meter min="0" max="{3}" value="{2}" aria-label="points"></meter>
<nav aria-label="tasks"><ul>{4}</ul></nav></header>
<main>
)",
                       lab.two_digits(), html(manifest.title), points_text(points), manifest.points(), contents) +
           page.text + "</main>\n<footer>Made by <code>./relief check " + lab.two_digits() + "</code>, drawn by " +
           html(describe_context().driver()) + ".</footer>\n" + script + page_end();
}

}  // namespace relief
