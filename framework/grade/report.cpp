#include "framework/grade/report.h"

#include <fmt/format.h>

#include <algorithm>

namespace relief {
namespace {

std::string html(const std::string& text) {
    std::string result;
    for (const char c : text) switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            case '\'':
                result += "&#39;";
                break;
            default:
                result += c;
        }
    return result;
}

constexpr const char* head = R"(<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>Relief: marks</title>
<style>
:root { color-scheme: light dark; --line: #8884; }
body { margin: 0 auto; max-width: 1100px; padding: 24px; font: 16px/1.5 system-ui, sans-serif; }
table { border-collapse: collapse; width: 100%; margin: 8px 0 24px; }
th, td { text-align: left; padding: 5px 10px; border-bottom: 1px solid var(--line); vertical-align: top; }
td.points, th.points { text-align: right; font-variant-numeric: tabular-nums; }
.outcome { font-weight: 600; white-space: nowrap; }
.passed { color: #2a8a43; } .unfinished { color: #b07a00; } .machine { color: #7a5cc0; }
.wrong, .broken, .crashed, .out_of_time, .out_of_memory { color: #c8402f; }
.hint { border-left: 4px solid #e58a5b; padding: 2px 12px; margin: 4px 0; }
pre { overflow-x: auto; background: #8882; padding: 8px 12px; }
</style></head><body>
<h1>Marks</h1>
)";

std::string check_row(const CheckMark& check) {
    const char* const outcome = name_of(check.outcome);
    std::string words(outcome);
    std::replace(words.begin(), words.end(), '_', ' ');
    return fmt::format("<tr><td class=\"outcome {}\">{}</td><td>{}{}</td><td>{}{}</td></tr>\n", outcome, words,
                       html(check.name), check.hidden ? " <small>(hidden)</small>" : "", html(check.found),
                       check.look_at.empty() ? "" : "<br>look at: " + html(check.look_at));
}

std::string task_part(const TaskMark& task) {
    std::string text =
        fmt::format("<h3>{} {}: {} of {}</h3>\n", html(task.id), html(task.title), points_text(task.points), task.of);
    if (!task.hint.empty())
        text += fmt::format("<p class=\"hint\">As in the known mistake <b>{}</b>: {}</p>\n", html(task.mistake),
                            html(task.hint));
    text +=
        "<table><thead><tr><th scope=\"col\">result</th><th scope=\"col\">check</th><th "
        "scope=\"col\">found</th></tr></thead><tbody>\n";
    for (const CheckMark& check : task.checks) text += check_row(check);
    return text + "</tbody></table>\n";
}

std::string student_part(const SubmissionMark& mark, size_t number) {
    std::string text = fmt::format("<section id=\"s{}\"><h2>{}</h2>\n", number, html(printable(mark.name)));
    if (!mark.problem.empty()) text += fmt::format("<p>{}</p>\n", html(mark.problem));
    if (!mark.graded()) text += "<p>Not graded: the machine failed. It costs no mark; grade again.</p>\n";
    for (const LabMark& lab : mark.labs) {
        text += fmt::format("<details{}><summary>{}: {} of {}</summary>\n", lab.points() < lab.of() ? " open" : "",
                            html(lab.lab), points_text(lab.points()), lab.of());
        for (const TaskMark& task : lab.tasks) text += task_part(task);
        if (!lab.log.empty()) text += "<pre>" + html(lab.log) + "</pre>\n";
        text += "</details>\n";
    }
    if (mark.ignored_count > 0) {
        text += fmt::format("<details><summary>{} other files, not looked at</summary><ul>\n", mark.ignored_count);
        for (const std::string& name : mark.ignored) text += "<li>" + html(name) + "</li>\n";
        text += "</ul></details>\n";
    }
    return text + "</section>\n";
}

std::string class_table(const std::vector<SubmissionMark>& marks) {
    std::set<std::string> labs;
    for (const SubmissionMark& mark : marks)
        for (const LabMark& lab : mark.labs) labs.insert(lab.lab);
    std::string text = "<table><caption>The class</caption><thead><tr><th scope=\"col\">submission</th>";
    for (const std::string& lab : labs) text += fmt::format("<th scope=\"col\" class=\"points\">{}</th>", html(lab));
    text += "<th scope=\"col\" class=\"points\">all</th></tr></thead><tbody>\n";
    for (size_t i = 0; i < marks.size(); ++i) {
        const SubmissionMark& mark = marks[i];
        text += fmt::format("<tr><th scope=\"row\"><a href=\"#s{}\">{}</a></th>", i, html(printable(mark.name)));
        for (const std::string& lab : labs) {
            const LabMark* const one = mark.lab(lab);
            text += fmt::format("<td class=\"points\">{}</td>",
                                !one             ? "-"
                                : !one->graded() ? "not graded"
                                                 : points_text(one->points()) + "/" + std::to_string(one->of()));
        }
        text += fmt::format("<td class=\"points\">{}</td></tr>\n",
                            mark.graded() ? points_text(mark.points()) : "not graded");
    }
    return text + "</tbody></table>\n";
}

}  // namespace

std::string to_html(const ClassReport& report) {
    std::string text = head;
    text += fmt::format(
        "<p>{} submissions, {} of them as before, in {:.1f} seconds, {:.1f} of them for the solutions. All jobs "
        "together: "
        "compiling {:.1f}, drawing {:.1f}, comparing {:.1f} seconds. Isolation: {}{}.</p>\n",
        report.marks.size(), report.taken_over, report.seconds, report.prepared, report.times.compile,
        report.times.draw, report.times.compare, name_of(report.isolation.level),
        report.isolation.reason.empty() ? "" : " (" + html(report.isolation.reason) + ")");
    text += class_table(report.marks);
    for (size_t i = 0; i < report.marks.size(); ++i) text += student_part(report.marks[i], i);
    return text + "</body></html>\n";
}

}  // namespace relief
