#include "framework/pages/check_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "framework/context/context.h"
#include "framework/pages/check_figures.h"
#include "framework/pages/page.h"

namespace relief {
namespace {

/// As one would type it to draw the check's shot.
std::string command_for(const LabEntry& lab, const Manifest& manifest, const Shot& shot) {
    std::string command = fmt::format("./relief shot {} --size {}x{}", lab.two_digits(), shot.size.x, shot.size.y);
    const Orbit &camera = shot.camera, &usual = manifest.camera;
    if (camera != usual) command += fmt::format(" --camera {},{},{}", camera.yaw, camera.pitch, camera.distance);
    const bool other_view = camera.field_of_view != usual.field_of_view;
    if (other_view || camera.target != usual.target)
        command += fmt::format(",{},{},{}", camera.target.x, camera.target.y, camera.target.z);
    if (other_view) command += fmt::format(",{}", camera.field_of_view);
    if (shot.time != 0) command += fmt::format(" --time {}", shot.time);
    for (const auto& [knob, value] : shot.set) command += fmt::format(" --set {}={}", knob, value);
    if (shot.probe) command += " --probe " + shot.probe.name;
    return command + " -o mine.png";
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
                            html(check.name), outcome_badge(result.outcome));
        line(result.outcome == Outcome::broken ? "message" : "found", html(result.found));
        if (!check.reason.empty()) line("allowed", html(check.reason));
        if (!passed && result.outcome != Outcome::unfinished) line("look at", html(look_at(result)));
        line("draw it", "<code>" + html(command_for(lab_, manifest_, check.shot)) + "</code>");
        text += "</dl>\n" + check_figures(manifest_, check, result.drawn, result.expected, DrawnBy::reader) +
                "</details>\n";
    }

    void line(const char* name, const std::string& value) {
        text += fmt::format("<dt>{}</dt><dd>{}</dd>", name, value);
    }

    const LabEntry& lab_;
    const Manifest& manifest_;
};

constexpr const char* style = R"(
section { margin: 0 0 44px; }
nav ul { list-style: none; margin: 18px 0 0; padding: 0; display: flex; flex-wrap: wrap; gap: 8px; }
nav a { display: block; background: var(--card); border: 1px solid var(--line); border-radius: 8px; padding: 6px 12px;
  color: var(--text); text-decoration: none; }
nav a:hover { border-color: var(--accent); }
@media (max-width: 600px) { h1 { font-size: 32px; } }
)";

Outcome worst(const TaskResult& task) {
    Outcome outcome = Outcome::passed;
    for (const CheckResult& result : task.checks) outcome = std::max(outcome, result.outcome);
    return outcome;
}

}  // namespace

std::string look_at(const CheckResult& result) {
    if (result.look_at.empty() && result.outcome == Outcome::broken)
        return result.found.find("not finite") != std::string::npos
                   ? "a root of a negative number, or 0 / 0: nothing can be measured before the values are finite"
                   : "fix what the message names: nothing can be measured before it compiles and draws";
    return result.look_at;
}

std::string check_page(const LabEntry& lab, const Manifest& manifest, const std::vector<TaskResult>& tasks) {
    double points = 0;
    std::string contents;
    Page page(lab, manifest);
    for (const TaskResult& task : tasks) {
        points += task.points();
        contents +=
            fmt::format(R"(<li><a href="#task-{0}">{0} {1}</a></li>)", html(task.task->id), outcome_badge(worst(task)));
        page.add(task);
    }
    const std::string body =
        fmt::format(R"(<header><h1><span class="number">{0}</span> {1}</h1>
<p class="points">{2} of {3} points</p>
<meter min="0" max="{3}" value="{2}" aria-label="points"></meter>
<nav aria-label="tasks"><ul>{4}</ul></nav></header>
<main>
)",
                    lab.two_digits(), html(manifest.title), points_text(points), manifest.points(), contents) +
        page.text + "</main>\n<footer>Made by <code>./relief check " + lab.two_digits() + "</code>, drawn by " +
        html(describe_context().driver()) + ".</footer>\n";
    return closed_page(fmt::format("Lab {}: {} of {} points", lab.two_digits(), points_text(points), manifest.points()),
                       check_style() + style, body, check_script());
}

}  // namespace relief
