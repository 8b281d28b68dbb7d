#include "framework/staff/pages/student_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "framework/pages/check_figures.h"
#include "framework/pages/page.h"

namespace relief {
namespace {

constexpr const char* student_style = R"(
header .up { margin: 0 0 18px; } h1 { overflow-wrap: anywhere; }
section { margin: 0 0 44px; } section section { margin: 0 0 34px; }
h2 { font-size: 28px; } h3.task { font-size: 21px; margin: 0 0 2px; } h3 .number { color: var(--accent); margin-right: 6px; }
nav ul { list-style: none; margin: 18px 0 0; padding: 0; display: flex; flex-wrap: wrap; gap: 8px; }
nav a { display: block; background: var(--card); border: 1px solid var(--line); border-radius: 8px; padding: 6px 12px; color: var(--text); text-decoration: none; }
nav a:hover { border-color: var(--accent); }
.hint { background: var(--card); border: 1px solid var(--accent); border-left-width: 6px; border-radius: 12px; padding: 14px 22px; margin: 0 0 14px; }
.hint p { margin: 0; font-size: 19px; } .hint .quiet { font-size: 15px; margin: 0 0 4px; }
.kept { display: flex; flex-wrap: wrap; gap: 4px 14px; align-items: baseline; padding: 8px 22px; margin: 0 0 14px; }
.kept .quiet { margin: 0; flex: 1 1 12em; }
.hidden { font-size: 13px; font-weight: 400; border: 1px solid var(--bad); color: var(--bad); border-radius: 6px; padding: 1px 7px; white-space: nowrap; margin-left: 8px; }
.problem { border: 1px solid var(--bad); border-radius: 12px; background: var(--card); padding: 14px 22px; margin: 18px 0 0; }
.more { background: var(--card); border: 1px solid var(--line); border-radius: 12px; padding: 0 22px; margin: 0 0 14px; }
.more summary { cursor: pointer; padding: 12px 0; } .more summary::before { content: "▸"; display: inline-block; width: 1.2em; color: var(--quiet); }
.more[open] summary::before { content: "▾"; } .more ul { margin: 0 0 14px; padding-left: 22px; overflow-wrap: anywhere; }
pre { overflow-x: auto; background: var(--code); border-radius: 8px; padding: 12px 16px; margin: 0 0 16px; font-size: 14px; max-height: 60vh; }
@media (max-width: 600px) { h1 { font-size: 32px; } .kept { padding: 8px 14px; } header, main, footer { padding-left: 14px; padding-right: 14px; } }
@media print { nav, .up { display: none; } pre { max-height: none; white-space: pre-wrap; } }
)";

class StudentPage {
public:
    StudentPage(const SubmissionMark& mark, const std::vector<CheckPictures>& pictures, PageFor reader)
        : mark_(mark), pictures_(pictures), for_student_(reader == PageFor::student) {}

    std::string text() {
        for (const LabMark& lab : mark_.labs) add(lab);
        return header() + "<main>\n" + body_ + ignored() + "</main>\n<footer>" + footer() + "</footer>\n";
    }

private:
    std::string header() const {
        std::string text = "<header>";
        if (!for_student_)
            text +=
                "<p class=\"up\"><a href=\"../report.html\"><span aria-hidden=\"true\">←</span> The class</a></p>\n";
        text += "<h1>" + name_html(mark_.name) + "</h1>\n";
        if (!mark_.graded())
            text += fmt::format(
                "<p class=\"problem\"><b>Not graded:</b> the grading machine failed. This costs nobody a "
                "point{}.</p>\n",
                for_student_ ? "" : "; grade again");
        else if (mark_.problem.empty())
            text += fmt::format(
                "<p class=\"points\">{0} of {1} points</p>\n<meter min=\"0\" max=\"{1}\" value=\"{0}\" "
                "aria-label=\"points\"></meter>\n",
                points_text(mark_.points()), mark_.max_points());
        if (!mark_.problem.empty()) text += "<p class=\"problem\">" + html(mark_.problem) + "</p>\n";
        if (!contents_.empty()) text += "<nav aria-label=\"tasks\"><ul>" + contents_ + "</ul></nav>\n";
        return text + "</header>\n";
    }

    void add(const LabMark& lab) {
        const std::string id = html(number_of(lab.lab));
        body_ += fmt::format(
            "<section aria-labelledby=\"lab-{0}\"><h2 id=\"lab-{0}\"><span class=\"number\">{0}</span> "
            "{1}</h2>\n",
            id, html(words_of(lab.lab)));
        if (lab.graded())
            body_ +=
                fmt::format("<p class=\"quiet\">{} of {} points</p>\n", points_text(lab.points()), lab.max_points());
        if (!lab.log.empty())
            body_ += fmt::format(
                "<details class=\"more\"{}><summary>What the compiler said</summary><pre "
                "role=\"region\" aria-label=\"what the compiler said about lab {}\" "
                "tabindex=\"0\">{}</pre></details>\n",
                lab.points() == 0 ? " open" : "", id, html(lab.log));
        for (const TaskMark& task : lab.tasks) add(lab, task);
        body_ += "</section>\n";
    }

    void add(const LabMark& lab, const TaskMark& task) {
        Outcome worst = Outcome::passed;
        for (const CheckMark& check : task.checks) worst = std::max(worst, check.outcome);
        const std::string id = html(task.id);
        contents_ += fmt::format("<li><a href=\"#task-{0}\">{0} {1}</a></li>", id, outcome_badge(worst));
        body_ += fmt::format(
            "<section aria-labelledby=\"task-{0}\"><h3 class=\"task\" id=\"task-{0}\"><span "
            "class=\"number\">{0}</span>{1}</h3>\n<p class=\"quiet\">{2} · <code>{3}</code></p>\n",
            id, html(task.title),
            lab.graded() ? fmt::format("{} of {} points", points_text(task.points), task.of)
                         : fmt::format("not graded, {} points", task.of),
            html(task.file));
        if (!task.hint.empty())
            body_ += fmt::format(
                "<div class=\"hint\"><p class=\"quiet\">It looks like a known mistake: <code>{}</code></p>"
                "<p>{}</p></div>\n",
                html(task.mistake), html_with_code(task.hint));
        for (const CheckMark& check : task.checks) add(lab, task, check);
        body_ += "</section>\n";
    }

    void add(const LabMark& lab, const TaskMark& task, const CheckMark& check) {
        if (for_student_ && (check.hidden || !check.view.empty())) return add_secret(check);
        const std::string name = html(check.name) + (check.hidden ? " <span class=\"hidden\">hidden check</span>" : "");
        any_hidden_ |= check.hidden;
        const auto one_line = [&](const std::string& said) {
            body_ += fmt::format("<div class=\"check kept\">{}<span>{}</span><span class=\"quiet\">{}</span></div>\n",
                                 outcome_badge(check.outcome), name, html(said));
        };
        if (check.outcome == Outcome::passed) return one_line(check.found);
        const CheckPictures* const shown = pictures_of(lab, task, check);
        const CheckMark* const before = &check == &task.checks.front() ? nullptr : &check - 1;
        if (!shown && before && before->outcome == check.outcome && before->found == check.found)
            return one_line("as above");
        const bool hidden_view = shown && shown->hidden_view;
        any_hidden_ |= hidden_view;
        body_ +=
            fmt::format("<details class=\"check\" open><summary><h4>{}{}</h4>{}</summary>\n<dl>", name,
                        hidden_view ? " <span class=\"hidden\">hidden view</span>" : "", outcome_badge(check.outcome));
        line(check.outcome == Outcome::wrong ? "found" : "message", check.found);
        if (!check.view.empty()) line("view", check.view);
        if (check.outcome == Outcome::wrong && shown) line("allowed", shown->check.reason);
        line("look at", check.look_at);
        body_ += "</dl>\n";
        if (shown)
            body_ += check_figures(*shown->manifest, shown->check, shown->drawn, shown->expected, DrawnBy::submission);
        else
            lost_pictures_ |= check.outcome == Outcome::wrong;
        body_ += "</details>\n";
    }

    /// What a student may know of what he cannot look at.
    void add_secret(const CheckMark& check) {
        any_hidden_ |= check.hidden;
        const std::string name = check.hidden ? "a <span class=\"hidden\">hidden check</span>" : html(check.name);
        if (check.outcome == Outcome::passed) {
            body_ +=
                fmt::format("<div class=\"check kept\">{}<span>{}</span></div>\n", outcome_badge(check.outcome), name);
            return;
        }
        body_ += fmt::format("<details class=\"check\" open><summary><h4>{}</h4>{}</summary>\n<dl>", name,
                             outcome_badge(check.outcome));
        line("found", found_for_students(check));
        line("look at", check.look_at);
        body_ += "</dl>\n</details>\n";
    }

    void line(const char* name, const std::string& value) {
        if (!value.empty()) body_ += fmt::format("<dt>{}</dt><dd>{}</dd>", name, html(value));
    }

    const CheckPictures* pictures_of(const LabMark& lab, const TaskMark& task, const CheckMark& check) const {
        for (const CheckPictures& one : pictures_)
            if (one.lab == lab.lab && one.check.task == task.id && one.check.name == check.name) return &one;
        return nullptr;
    }

    std::string ignored() const {
        if (mark_.ignored_count == 0) return {};
        std::string text = fmt::format("<details class=\"more\"><summary>{}, ignored</summary><ul>\n",
                                       count_of(mark_.ignored_count, "other file"));
        for (const std::string& name : mark_.ignored) text += "<li><bdi>" + html(name) + "</bdi></li>\n";
        if (mark_.ignored.size() < mark_.ignored_count)
            text += fmt::format("<li>and {} more</li>\n", mark_.ignored_count - mark_.ignored.size());
        return text + "</ul></details>\n";
    }

    std::string footer() const {
        std::string text = "Made by <code>./relief grade</code>.";
        if (any_hidden_) text += " Hidden checks and views are not in the students' course.";
        if (lost_pictures_ && !for_student_)
            text += " The pictures were not stored: <code>--fresh</code> draws them again.";
        return text;
    }

    const SubmissionMark& mark_;
    const std::vector<CheckPictures>& pictures_;
    bool for_student_;
    std::string body_, contents_;
    bool any_hidden_ = false, lost_pictures_ = false;
};

}  // namespace

std::string number_of(const std::string& folder) { return folder.substr(0, folder.find('_')); }
std::string words_of(const std::string& folder) {
    const size_t at = folder.find('_');
    std::string words = at == std::string::npos ? folder : folder.substr(at + 1);
    std::replace(words.begin(), words.end(), '_', ' ');
    return words;
}

std::string name_html(const std::string& name) { return "<bdi>" + html(printable(name)) + "</bdi>"; }

std::string count_of(size_t count, const std::string& what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::string student_page(const SubmissionMark& mark, const std::vector<CheckPictures>& pictures, PageFor reader) {
    const std::string title =
        printable(mark.name) + (mark.graded() && mark.problem.empty()
                                    ? fmt::format(": {} of {} points", points_text(mark.points()), mark.max_points())
                                    : "");
    return closed_page(title, check_style() + student_style, StudentPage(mark, pictures, reader).text(),
                       check_script());
}

}  // namespace relief
