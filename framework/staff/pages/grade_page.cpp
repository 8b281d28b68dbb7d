#include "framework/staff/pages/grade_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "framework/base/text.h"
#include "framework/pages/check_figures.h"
#include "framework/pages/page.h"
#include "framework/staff/pages/student_page.h"
#include "framework/staff/pages/summaries.h"

namespace relief {
namespace {

constexpr int outcomes = int(Outcome::machine) + 1;
using Counts = std::array<size_t, outcomes>;

/// A known mistake, as one word to the filter: ids are told apart only within a lab.
std::string named(const TaskMark& task) { return task.id + "\u00a0" + task.mistake; }

/// Everything that is counted over a class.
class ClassCounts {
public:
    struct OfCheck {
        std::string task, name;
        bool hidden = false;
        Counts of{};
        size_t all() const {
            size_t sum = 0;
            for (const size_t count : of) sum += count;
            return sum;
        }
        size_t passed() const { return of[size_t(Outcome::passed)]; }
    };
    struct OfMistake {
        std::string hint;
        size_t count = 0;
    };
    std::map<std::string, std::vector<OfCheck>> checks;  ///< by lab, in the order of its tasks
    std::map<std::string, OfMistake> mistakes;           ///< by named()
    std::set<std::string> isolations;
    MarkTimes times;
    double waiting = 0;
    size_t not_graded = 0;
    std::vector<double> points;

    explicit ClassCounts(const std::vector<SubmissionMark>& marks) {
        for (const SubmissionMark& mark : marks) add(mark);
        std::sort(points.begin(), points.end());
    }

    double median() const {
        return points.empty() ? 0 : 0.5 * (points[(points.size() - 1) / 2] + points[points.size() / 2]);
    }

private:
    void add(const SubmissionMark& mark) {
        if (mark.graded())
            points.push_back(mark.points());
        else
            ++not_graded;
        if (!mark.isolation.empty()) isolations.insert(mark.isolation);
        double busy = 0;
        for (const LabMark& lab : mark.labs) {
            times.add(lab.times);
            busy += lab.times.sum();
            for (const TaskMark& task : lab.tasks) add(lab.lab, task);
        }
        waiting += std::max(0.0, mark.seconds - busy);
    }

    void add(const std::string& lab, const TaskMark& task) {
        for (const CheckMark& check : task.checks) {
            std::vector<OfCheck>& known = checks[lab];
            const auto [entry, is_new] = place_.try_emplace({lab, task.id, check.name}, known.size());
            if (is_new) known.push_back({task.id, check.name, check.hidden});
            ++known[entry->second].of[size_t(check.outcome)];
        }
        if (task.mistake.empty()) return;
        OfMistake& mistake = mistakes[named(task)];
        mistake.hint = task.hint;
        ++mistake.count;
    }

    std::map<std::array<std::string, 3>, size_t> place_;
};

constexpr const char* class_style = R"(
header p { max-width: none; }
section { margin: 0 0 52px; }
h2 { font-size: 26px; margin: 0 0 10px; } h3 { font-size: 18px; margin: 26px 0 8px; }
h3 .number { color: var(--accent); margin-right: 6px; }
.quiet { color: var(--quiet); font-size: 15px; margin: 0 0 14px; }
.numbers { display: flex; flex-wrap: wrap; gap: 12px; margin: 22px 0 0; }
.numbers div { background: var(--card); border: 1px solid var(--line); border-radius: 12px; padding: 12px 20px; min-width: 130px; }
.numbers dt { color: var(--quiet); font-size: 14px; } .numbers dd { margin: 0; font-size: 24px; font-variant-numeric: tabular-nums; }
.bad { color: var(--bad); }
nav { margin: 22px 0 0; display: flex; flex-wrap: wrap; gap: 4px 22px; }
.filter { display: flex; flex-wrap: wrap; gap: 8px 16px; align-items: end; margin: 0 0 14px; }
.filter label { font-size: 15px; color: var(--quiet); flex: 0 1 420px; }
.filter input { border-color: var(--edge); margin-top: 4px; }
output { padding: 8px 0; font-variant-numeric: tabular-nums; }
.scroll { overflow: auto; background: var(--card); border: 1px solid var(--line); border-radius: 12px; }
.long { max-height: 85vh; }
table { border-collapse: separate; border-spacing: 0; width: 100%; }
caption { text-align: left; color: var(--quiet); font-size: 15px; padding: 10px 16px; }
th, td { text-align: left; padding: 7px 16px; vertical-align: top; font-weight: normal; border-top: 1px solid var(--line); }
td.number, th.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
thead th { position: sticky; top: 0; background: var(--card); z-index: 1; border: 0; box-shadow: inset 0 -2px var(--line); color: var(--quiet); font-size: 15px; padding: 0 6px; white-space: nowrap; }
thead th.plain { padding: 8px 16px; }
thead button { font: inherit; color: inherit; background: none; border: 0; border-radius: 6px; padding: 8px 10px; cursor: pointer; }
thead button:hover { color: var(--text); background: var(--code); }
thead button::after { content: "↕"; opacity: 0.55; margin-left: 6px; }
thead [aria-sort=ascending] button::after { content: "▲"; opacity: 1; } thead [aria-sort=descending] button::after { content: "▼"; opacity: 1; }
thead th:is([aria-sort=ascending], [aria-sort=descending]) { color: var(--text); font-weight: 600; }
tbody th { position: sticky; left: 0; background: var(--card); max-width: 24em; overflow-wrap: anywhere; min-width: 11em; }
tbody tr:hover > * { background-color: var(--ground); }
.share { background: linear-gradient(to right, var(--tint) var(--p), transparent 0) 0 5px / 100% 29px no-repeat; }
.none { color: var(--quiet); } td.told, td.told + td { min-width: 15em; }
td .badge { margin-right: 12px; }
td code { margin: 1px 4px 1px 0; display: inline-block; }
.bars { display: grid; grid-template-columns: 20em minmax(8em, 1fr) 23em; gap: 6px 18px; align-items: center;
  list-style: none; margin: 0; padding: 0; }
.bars li { display: contents; }
.bar { display: flex; height: 16px; border-radius: 5px; overflow: hidden; background: var(--code); gap: 1px; }
.bar i { display: block; min-width: 2px; background: var(--bad); } .bar :is(.broken, .crashed, .out_of_time, .out_of_memory) { background: var(--worse); } .bar .passed { background: var(--good); } .bar .unfinished { background: var(--open); }
.bar .machine { background: var(--accent); }
.bars .told { font-size: 15px; } .bars .told span { white-space: nowrap; }
.hidden { font-size: 13px; border: 1px solid var(--edge); color: var(--quiet); border-radius: 6px; padding: 1px 7px; white-space: nowrap; }
.time { max-width: 760px; } .time .bar { height: 20px; margin: 0 0 8px; }
.time ul { list-style: none; margin: 0 0 6px; padding: 0; display: flex; flex-wrap: wrap; gap: 2px 22px; }
.time li i { display: inline-block; width: 12px; height: 12px; border-radius: 3px; margin-right: 7px; }
.time .draw { background: var(--accent); } .time .compare { background: var(--good); } .time .waiting { background: var(--edge); } .time .compile { background: var(--open); }
button.pick { font: inherit; color: var(--accent); background: none; border: 1px solid var(--edge); border-radius: 8px; padding: 3px 12px; cursor: pointer; white-space: nowrap; }
button.pick:hover { border-color: var(--accent); }
:root { --edge: #8a857a; --tint: #f6e3d5; --worse: #6f1712; }
@media (prefers-color-scheme: dark) { :root { --edge: #7c818c; --tint: #46301f; --worse: #d6564a; } }
@media (scripting: none) { .filter, .pick { display: none; } thead button::after { content: ""; } thead button { pointer-events: none; } }
@media (max-width: 700px) { h1 { font-size: 34px; } header, main, footer { padding-left: 14px; padding-right: 14px; } th, td { padding: 7px 10px; }
  .bars { grid-template-columns: 1fr; gap: 2px; } .bars .told { margin-bottom: 12px; } .numbers div { flex: 1; padding: 8px 14px; } .numbers dd { font-size: 20px; } }
@media print { .scroll { max-height: none; overflow: visible; border: 0; } .filter, nav, .pick { display: none; } thead button::after { content: ""; }
  thead th { position: static; } tr, .bars li > * { break-inside: avoid; } }
)";

// Without it the table stands as it was graded and everything can be read.
constexpr const char* class_script = R"(
const table = document.querySelector("#marks"), body = table.tBodies[0], rows = [...body.rows];
const sorters = [...table.tHead.rows[0].cells].filter(cell => cell.querySelector("button"));
const order = new Intl.Collator(undefined, {numeric: true, sensitivity: "base"});
for (const head of sorters) head.querySelector("button").addEventListener("click", () => {
  const column = head.cellIndex, up = head.ariaSort != "ascending", sign = up ? 1 : -1;
  for (const other of sorters) other.ariaSort = other == head ? (up ? "ascending" : "descending") : "none";
  const key = row => column == 0 ? row.cells[0].textContent : parseFloat(row.cells[column].textContent);
  const keys = new Map(rows.map(row => [row, key(row)]));
  const compare = (a, b) => column == 0 ? sign * order.compare(a, b)
    : isNaN(a) || isNaN(b) ? isNaN(a) - isNaN(b) : sign * (a - b);  // without a number: last, either way
  body.append(...rows.sort((a, b) => compare(keys.get(a), keys.get(b))));
});
const filter = document.querySelector("#filter"), told = document.querySelector("#shown");
const words_of = row => [row.cells[0], ...[...row.cells].slice(-2)].map(cell => cell.textContent).join(" ").toLowerCase();
const texts = new Map(rows.map(row => [row, words_of(row)]));
const sift = () => {
  const words = filter.value.toLowerCase().split(/[ \t]+/).filter(word => word);
  let shown = 0;
  for (const row of rows) {
    row.hidden = !words.every(word => texts.get(row).includes(word));
    shown += !row.hidden;
  }
  told.textContent = `${shown} of ${rows.length} shown`;
};
filter.addEventListener("input", sift);
sift();
for (const button of document.querySelectorAll(".pick")) button.addEventListener("click", () => {
  filter.value = button.value;
  sift();
  filter.focus();
});
)";

std::string number_card(const char* name, const std::string& value, const char* kind = "") {
    return fmt::format("<div><dt>{}</dt><dd{}>{}</dd></div>\n", name, *kind ? fmt::format(" class=\"{}\"", kind) : "",
                       value);
}

std::string class_header(const ClassReport& report, const ClassCounts& counts) {
    std::string text = "<header><h1>Marks</h1>\n<dl class=\"numbers\">\n";
    text += number_card("submissions", std::to_string(report.marks.size()));
    text += number_card("median", amount_of(counts.median(), "point"));
    if (counts.not_graded > 0) text += number_card("not graded: grade again", std::to_string(counts.not_graded), "bad");
    text += number_card("unchanged, not graded again", std::to_string(report.taken_over));
    std::string isolation;
    for (const std::string& one : counts.isolations) isolation += (isolation.empty() ? "" : ", ") + one;
    text += number_card("isolation", html(isolation.empty() ? "none needed" : isolation));
    if (!report.seed.empty()) text += number_card("seed of hidden views", html(printable(report.seed)));
    text += "</dl>\n";
    if (!report.isolation.reason.empty()) text += "<p>Isolation: " + html(report.isolation.reason) + "</p>\n";
    return text +
           "<nav aria-label=\"on this page\"><a href=\"#class\">The class</a> <a href=\"#checks\">Check by check</a> "
           "<a href=\"#mistakes\">Known mistakes</a> <a href=\"#time\">Time</a></nav></header>\n<main>\n";
}

/// What became of a submission's checks, and the mistakes that were recognised.
std::string outcome_cells(const SubmissionMark& mark) {
    Counts of{};
    std::set<std::string> mistakes;
    size_t all = 0;
    for (const LabMark& lab : mark.labs)
        for (const TaskMark& task : lab.tasks) {
            for (const CheckMark& check : task.checks) ++of[size_t(check.outcome)], ++all;
            if (!task.mistake.empty()) mistakes.insert(named(task));
        }
    std::string text = "<td class=\"told\">";
    if (!mark.problem.empty()) text += "<span class=\"bad\">" + html(mark.problem) + "</span>";
    if (all > 0 && of[size_t(Outcome::passed)] == all)
        text += "<span class=\"badge passed\"><span aria-hidden=\"true\">✓</span> all passed</span>";
    for (int i = 1; i < outcomes; ++i)
        if (of[size_t(i)] > 0) text += outcome_badge(Outcome(i), of[size_t(i)]) + " ";
    text += "</td><td>";
    for (const std::string& mistake : mistakes) text += "<code>" + html(mistake) + "</code> ";
    return text + "</td>";
}

std::string class_table(const ClassReport& report, const ClassCounts& counts) {
    const auto sorter = [](const std::string& kind, const std::string& words) {
        return fmt::format("<th scope=\"col\" aria-sort=\"none\"{}><button type=\"button\">{}</button></th>", kind,
                           words);
    };
    std::string text = R"(<section id="class" aria-labelledby="class-title"><h2 id="class-title">The class</h2>
<div class="filter"><label for="filter">Filter by name, outcome or known mistake<input id="filter" type="search" autocomplete="off" spellcheck="false"></label><output id="shown" for="filter"></output></div>
<div class="LONG" role="region" aria-labelledby="class-title" tabindex="0"><table id="marks">
<caption>Points of each submission, in all and by lab. A name opens its page.</caption>
<thead><tr>)";
    text.replace(text.find("LONG"), 4, report.marks.size() > 50 ? "scroll long" : "scroll");
    text += sorter("", "submission") + sorter(" class=\"number\"", "points");
    for (const auto& [lab, checks] : counts.checks)
        text +=
            sorter(fmt::format(" class=\"number\" title=\"{}\"", html(words_of(lab))), "lab " + html(number_of(lab)));
    text +=
        "<th scope=\"col\" class=\"plain\">checks that did not pass</th><th scope=\"col\" class=\"plain\">known "
        "mistakes</th></tr></thead><tbody>\n";
    for (const SubmissionMark& mark : report.marks) {
        text += fmt::format("<tr><th scope=\"row\"><a href=\"{}\">{}</a></th>",
                            page_file(mark.name, PageFor::instructor).string(), name_html(mark.name));
        const auto cell = [&](double points, int of, bool graded) {
            if (of == 0) return std::string("<td class=\"number none\">–</td>");
            if (!graded) return std::string("<td class=\"number none\">not graded</td>");
            return fmt::format("<td class=\"number share\" style=\"--p:{:.0f}%\">{} / {}</td>", 100 * points / of,
                               points_text(points), of);
        };
        text += cell(mark.points(), mark.max_points(), mark.graded());
        for (const auto& [lab, checks] : counts.checks) {
            const LabMark* const one = mark.lab(lab);
            text += one ? cell(one->points(), one->max_points(), one->graded()) : "<td class=\"number none\">–</td>";
        }
        text += outcome_cells(mark) + "</tr>\n";
    }
    return text + "</tbody></table></div></section>\n";
}

std::string bar_of(const Counts& of) {
    std::string text = "<div class=\"bar\" aria-hidden=\"true\">";
    for (int i = 0; i < outcomes; ++i)
        if (of[size_t(i)] > 0)
            text += fmt::format("<i class=\"{}\" style=\"flex:{}\"></i>", name_of(Outcome(i)), of[size_t(i)]);
    return text + "</div>";
}

std::string check_histogram(const ClassCounts& counts) {
    std::string text =
        "<section id=\"checks\" aria-labelledby=\"checks-title\"><h2 id=\"checks-title\">Check by "
        "check</h2>\n";
    if (counts.checks.empty()) return text + "<p class=\"quiet\">Nothing was checked.</p></section>\n";
    std::vector<const ClassCounts::OfCheck*> hardest;
    for (const auto& [lab, checks] : counts.checks)
        for (const ClassCounts::OfCheck& check : checks)
            if (check.passed() < check.all()) hardest.push_back(&check);
    std::stable_sort(hardest.begin(), hardest.end(), [](const auto* a, const auto* b) {
        return double(a->passed()) * double(b->all()) < double(b->passed()) * double(a->all());
    });
    if (!hardest.empty()) {
        text += "<p class=\"quiet\">The hardest checks: ";
        for (size_t i = 0; i < std::min<size_t>(3, hardest.size()); ++i)
            text += fmt::format("{}<b>{} {}</b> ({} of {})", i > 0 ? ", " : "", html(hardest[i]->task),
                                html(hardest[i]->name), hardest[i]->passed(), hardest[i]->all());
        text += ".</p>\n";
    }
    for (const auto& [lab, checks] : counts.checks) {
        text += fmt::format("<h3><span class=\"number\">{}</span> {}</h3>\n<ul class=\"bars\">\n", html(number_of(lab)),
                            html(words_of(lab)));
        for (const ClassCounts::OfCheck& check : checks) {
            text += fmt::format("<li><span>{} {}{}</span>{}<span class=\"told\">", html(check.task), html(check.name),
                                check.hidden ? " <span class=\"hidden\">hidden</span>" : "", bar_of(check.of));
            std::string said;
            for (int i = 0; i < outcomes; ++i)
                if (check.of[size_t(i)] > 0)
                    said += fmt::format("{}<span>{} {}</span>", said.empty() ? "" : " · ", check.of[size_t(i)],
                                        outcome_words(Outcome(i)));
            text += said + "</span></li>\n";
        }
        text += "</ul>\n";
    }
    return text + "</section>\n";
}

std::string mistake_table(const ClassCounts& counts) {
    std::string text =
        "<section id=\"mistakes\" aria-labelledby=\"mistakes-title\"><h2 id=\"mistakes-title\">Known "
        "mistakes</h2>\n";
    if (counts.mistakes.empty()) return text + "<p class=\"quiet\">None was recognised.</p></section>\n";
    std::vector<std::pair<std::string, ClassCounts::OfMistake>> list(counts.mistakes.begin(), counts.mistakes.end());
    std::stable_sort(list.begin(), list.end(),
                     [](const auto& a, const auto& b) { return a.second.count > b.second.count; });
    text +=
        R"(<div class="scroll" role="region" aria-labelledby="mistakes-title" tabindex="0"><table><caption>What was recognised by its pictures, the most frequent first.</caption>
<thead><tr><th scope="col" class="plain">mistake</th><th scope="col" class="plain">hint</th><th scope="col" class="plain">submissions</th></tr></thead><tbody>
)";
    for (const auto& [id, mistake] : list)
        text += fmt::format(
            "<tr><th scope=\"row\"><code>{0}</code></th><td>{1}</td><td><button type=\"button\" class=\"pick\" "
            "value=\"{0}\" aria-label=\"show {2} with {0}\">show {2}</button></td></tr>\n",
            html(id), html_with_code(mistake.hint), mistake.count);
    return text + "</tbody></table></div></section>\n";
}

std::string time_part(const ClassReport& report, const ClassCounts& counts) {
    const double all = counts.times.sum() + counts.waiting;
    std::string text = "<section id=\"time\" aria-labelledby=\"time-title\"><h2 id=\"time-title\">Time</h2>\n";
    if (report.prepared > 0)
        text += fmt::format(
            "<p class=\"quiet\">This run took {:.1f} seconds, {:.1f} of them before the first "
            "submission: reading, and drawing the solutions.</p>\n",
            report.seconds, report.prepared);
    if (all <= 0) return text + "</section>\n";
    const std::tuple<const char*, double, const char*> parts[] = {
        {"compile", counts.times.compile, "compiling"},
        {"draw", counts.times.draw, "drawing"},
        {"compare", counts.times.compare, "comparing"},
        {"waiting", counts.waiting, "waiting, reading and recognising known mistakes"}};
    std::string bar, key;
    for (const auto& [kind, seconds, words] : parts) {
        bar += fmt::format("<i class=\"{}\" style=\"flex:{:.4f}\"></i>", kind, seconds / all);
        key += fmt::format("<li><i class=\"{}\" aria-hidden=\"true\"></i>{} {:.0f} % ({:.1f} s)</li>", kind, words,
                           100 * seconds / all, seconds);
    }
    return text + "<div class=\"time\"><div class=\"bar\" aria-hidden=\"true\">" + bar + "</div><ul>" + key +
           "</ul></div>\n<p class=\"quiet\">The time of all submissions together, whenever they were "
           "graded.</p></section>\n";
}

}  // namespace

std::string class_page(const ClassReport& report) {
    const ClassCounts counts(report.marks);
    return closed_page("Marks: " + count_of(report.marks.size(), "submission"), std::string(badge_style) + class_style,
                       class_header(report, counts) + class_table(report, counts) + check_histogram(counts) +
                           mistake_table(counts) + time_part(report, counts) +
                           "</main>\n<footer>Made by <code>./relief grade</code>.</footer>\n",
                       class_script);
}

}  // namespace relief
