#include "framework/staff/grade/results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "framework/base/error.h"
#include "framework/base/sha256.h"
#include "framework/base/text.h"

namespace relief {
namespace {

using nlohmann::ordered_json;

constexpr int schema = 1;

/// Untrusted bytes may not be UTF-8.
std::string dump(const ordered_json& json) {
    return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

ordered_json as_json(const CheckMark& check) {
    return {{"name", check.name},   {"outcome", name_of(check.outcome)},
            {"found", check.found}, {"look_at", check.look_at},
            {"view", check.view},   {"hidden", check.hidden}};
}
CheckMark check_from(const ordered_json& json) {
    return {.name = json.at("name"),
            .outcome = outcome_of(json.at("outcome").get<std::string>()),
            .found = json.at("found"),
            .look_at = json.at("look_at"),
            .view = json.at("view"),
            .hidden = json.at("hidden")};
}

ordered_json as_json(const TaskMark& task) {
    ordered_json json = {
        {"id", task.id}, {"title", task.title},     {"file", task.file}, {"points", task.points},
        {"of", task.of}, {"mistake", task.mistake}, {"hint", task.hint}, {"checks", ordered_json::array()}};
    for (const CheckMark& check : task.checks) json["checks"].push_back(as_json(check));
    return json;
}
TaskMark task_from(const ordered_json& json) {
    TaskMark task{.id = json.at("id"),
                  .title = json.at("title"),
                  .file = json.at("file"),
                  .of = json.at("of"),
                  .points = json.at("points"),
                  .checks = {},
                  .mistake = json.at("mistake"),
                  .hint = json.at("hint")};
    size_t passed = 0;
    for (const ordered_json& check : json.at("checks")) {
        task.checks.push_back(check_from(check));
        passed += task.checks.back().outcome == Outcome::passed;
    }
    const double earned = task.of * double(passed) / double(std::max<size_t>(task.checks.size(), 1));
    if (task.of < 0 || !(std::abs(task.points - earned) < 1e-6))
        throw Error(fmt::format("task {} has {} of {} points, with {} of {} checks passed", printable(task.id),
                                task.points, task.of, passed, task.checks.size()));
    return task;
}

ordered_json as_json(const LabMark& lab) {
    ordered_json json = {
        {"lab", lab.lab},
        {"points", lab.points()},
        {"of", lab.max_points()},
        {"seconds", {{"compile", lab.times.compile}, {"draw", lab.times.draw}, {"compare", lab.times.compare}}},
        {"log", lab.log},
        {"tasks", ordered_json::array()}};
    for (const TaskMark& task : lab.tasks) json["tasks"].push_back(as_json(task));
    return json;
}
LabMark lab_from(const ordered_json& json) {
    const ordered_json& seconds = json.at("seconds");
    LabMark lab{.lab = json.at("lab"),
                .tasks = {},
                .log = json.at("log"),
                .times = {seconds.at("compile"), seconds.at("draw"), seconds.at("compare")}};
    for (const ordered_json& task : json.at("tasks")) lab.tasks.push_back(task_from(task));
    return lab;
}

/// Untrusted text may not be UTF-8, which XML requires.
std::string valid_utf8(const std::string& text) {
    return ordered_json::parse(ordered_json(text).dump(-1, ' ', false, ordered_json::error_handler_t::replace));
}

std::string xml(const std::string& text) {
    std::string result = valid_utf8(text);
    for (char& c : result)
        if (static_cast<unsigned char>(c) < ' ' || c == 0x7f) c = ' ';  // XML has no word for them
    return escaped_markup(result);
}

/// A field of a CSV. Text that a spreadsheet would take for a formula gets an apostrophe.
std::string csv(const std::string& text) {
    std::string result =
        !text.empty() && std::string("=+-@\t\r").find(text[0]) != std::string::npos ? "'" + text : text;
    if (result.find_first_of(",\"\n\r") == std::string::npos) return result;
    std::string quoted = "\"";
    for (const char c : result) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + '"';
}

/// Every task that any submission has, in the course's order.
std::vector<std::pair<std::string, std::string>> all_tasks(const std::vector<SubmissionMark>& marks) {
    std::vector<std::pair<std::string, std::string>> tasks;
    std::map<std::string, std::vector<std::string>> by_lab;
    for (const SubmissionMark& mark : marks)
        for (const LabMark& lab : mark.labs)
            if (by_lab[lab.lab].empty())
                for (const TaskMark& task : lab.tasks) by_lab[lab.lab].push_back(task.id);
    for (const auto& [lab, ids] : by_lab)
        for (const std::string& id : ids) tasks.emplace_back(lab, id);
    return tasks;
}

std::string state_of(const SubmissionMark& mark) {
    return !mark.graded() ? "not graded: the machine failed" : mark.problem.empty() ? "graded" : mark.problem;
}

/// The text for a check on Gradescope, which shows hidden checks to instructors only.
std::string sentence(const CheckMark& check) {
    std::string text = check.hidden ? check.found : found_for_students(check);
    if (!check.look_at.empty()) text += "\nlook at: " + check.look_at;
    return text;
}

}  // namespace

double SubmissionMark::points() const {
    double sum = 0;
    for (const LabMark& one : labs) sum += one.points();
    return sum;
}
int SubmissionMark::max_points() const {
    int sum = 0;
    for (const LabMark& one : labs) sum += one.max_points();
    return sum;
}
bool SubmissionMark::graded() const {
    return std::all_of(labs.begin(), labs.end(), [](const LabMark& one) { return one.graded(); });
}
const LabMark* SubmissionMark::lab(const std::string& folder) const {
    for (const LabMark& one : labs)
        if (one.lab == folder) return &one;
    return nullptr;
}

std::string file_name_of(const std::string& name) {
    std::string plain;
    for (const char c : name.substr(0, 80))
        plain += std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_' || (c == '.' && !plain.empty())
                     ? c
                     : '-';
    return plain == name && !name.empty() ? plain : plain + "-" + sha256(name).substr(0, 8);
}

std::string found_for_students(const CheckMark& check) {
    if (check.hidden) return {};
    return check.view.empty() ? check.found : "correct in the view that you know, but not in another one";
}

std::string to_json(const SubmissionMark& mark) {
    ordered_json json = {{"schema", schema},
                         {"name", utf8_of_bytes(mark.name)},
                         {"graded", mark.graded()},
                         {"problem", mark.problem},
                         {"points", mark.points()},
                         {"of", mark.max_points()},
                         {"hash", mark.hash},
                         {"course", mark.course},
                         {"isolation", mark.isolation},
                         {"seconds", mark.seconds},
                         {"ignored", mark.ignored},
                         {"ignored_count", mark.ignored_count},
                         {"labs", ordered_json::array()}};
    for (const LabMark& lab : mark.labs) json["labs"].push_back(as_json(lab));
    return dump(json);
}

SubmissionMark from_json(const std::string& text) try {
    const ordered_json json = ordered_json::parse(text);
    if (json.at("schema") != schema) throw Error("its schema is not 1");
    SubmissionMark mark;
    mark.name = bytes_of_utf8(json.at("name").get<std::string>());
    mark.hash = json.at("hash");
    mark.course = json.at("course");
    mark.isolation = json.at("isolation");
    mark.problem = json.at("problem");
    mark.seconds = json.at("seconds");
    mark.ignored = json.at("ignored").get<std::vector<std::string>>();
    mark.ignored_count = json.at("ignored_count");
    for (const ordered_json& lab : json.at("labs")) mark.labs.push_back(lab_from(lab));
    return mark;
} catch (const nlohmann::json::exception& error) {
    throw Error(fmt::format("not a result of grading: {}", error.what()));
}

std::string to_gradescope(const SubmissionMark& mark) {
    if (!mark.graded())  // no score at all: Gradescope then says that grading failed
        return dump({{"output", "The grader's machine failed. This is not your fault and costs you no points."}});
    ordered_json json = {{"score", mark.points()},
                         {"execution_time", mark.seconds},
                         {"output", mark.problem},
                         {"visibility", "visible"},
                         {"tests", ordered_json::array()}};
    for (const LabMark& lab : mark.labs)
        for (const TaskMark& task : lab.tasks) {
            for (const CheckMark& check : task.checks) {
                const double share = double(task.of) / double(task.checks.size());
                const bool passed = check.outcome == Outcome::passed;
                json["tests"].push_back({{"name", fmt::format("{} {}: {}", task.id, task.title, check.name)},
                                         {"score", passed ? share : 0.0},
                                         {"max_score", share},
                                         {"status", passed ? "passed" : "failed"},
                                         {"output", fmt::format("{}: {}", name_of(check.outcome), sentence(check))},
                                         {"visibility", check.hidden ? "hidden" : "visible"},
                                         {"tags", {lab.lab}}});
            }
            if (!task.hint.empty())
                json["tests"].push_back({{"name", fmt::format("{} {}: a hint", task.id, task.title)},
                                         {"output", task.hint},
                                         {"visibility", "visible"},
                                         {"tags", {lab.lab}}});
        }
    return dump(json);
}

std::string to_csv(const std::vector<SubmissionMark>& marks) {
    const auto tasks = all_tasks(marks);
    std::string text = "submission,state,points";
    for (const auto& [lab, id] : tasks) text += "," + id;
    text += "\n";
    for (const SubmissionMark& mark : marks) {
        text += csv(printable(mark.name)) + "," + csv(state_of(mark)) + "," +
                (mark.graded() ? points_text(mark.points()) : "");
        for (const auto& [lab, id] : tasks) {
            text += ",";
            const LabMark* const one = mark.lab(lab);
            if (!one || !one->graded()) continue;
            for (const TaskMark& task : one->tasks)
                if (task.id == id) text += points_text(task.points);
        }
        text += "\n";
    }
    return text;
}

std::string to_junit(const std::vector<SubmissionMark>& marks) {
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"relief grade\">\n";
    for (const SubmissionMark& mark : marks) {
        std::string cases;
        int tests = 0, failures = 0, errors = 0;
        const auto one_case = [&](const std::string& group, const std::string& name, const char* kind,
                                  const std::string& type, const std::string& message) {
            cases += fmt::format("    <testcase classname=\"{}\" name=\"{}\"", xml(group), xml(name));
            cases +=
                kind ? fmt::format("><{} type=\"{}\" message=\"{}\"/></testcase>\n", kind, type, xml(message)) : "/>\n";
        };
        if (!mark.problem.empty()) {
            one_case("submission", "can be read", "failure", "unreadable", mark.problem);
            ++tests;
            ++failures;
        }
        for (const LabMark& lab : mark.labs)
            for (const TaskMark& task : lab.tasks)
                for (const CheckMark& check : task.checks) {
                    const bool passed = check.outcome == Outcome::passed, machine = check.outcome == Outcome::machine;
                    const char* const kind = passed ? nullptr : machine ? "error" : "failure";
                    ++tests;
                    failures += !passed && !machine;
                    errors += machine;
                    one_case(lab.lab + "." + task.id, check.name, kind, name_of(check.outcome), check.found);
                }
        text += fmt::format(
            "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.3f}\">\n{}  </testsuite>\n",
            xml(printable(mark.name)), tests, failures, errors, mark.seconds, cases);
    }
    return text + "</testsuites>\n";
}

std::string to_table(const std::vector<SubmissionMark>& marks) {
    std::vector<std::string> labs;
    for (const auto& [lab, id] : all_tasks(marks))
        if (labs.empty() || labs.back() != lab) labs.push_back(lab);
    size_t width = 10;
    for (const SubmissionMark& mark : marks) width = std::max(width, std::min<size_t>(40, printable(mark.name).size()));
    std::string text = fmt::format("{:<{}}", "submission", width);
    for (const std::string& lab : labs) text += fmt::format("  {:>7}", "lab " + lab.substr(0, 2));
    text += "      all\n";
    for (const SubmissionMark& mark : marks) {
        text += fmt::format("{:<{}}", printable(mark.name), width);
        for (const std::string& lab : labs) {
            const LabMark* const one = mark.lab(lab);
            text += fmt::format("  {:>7}", !one ? "-"
                                           : !one->graded()
                                               ? "?"
                                               : fmt::format("{}/{}", points_text(one->points()), one->max_points()));
        }
        text += mark.graded() ? fmt::format("  {:>7}", points_text(mark.points())) : "        ?";
        if (mark.problem.size() || !mark.graded()) text += "  " + state_of(mark);
        text += "\n";
    }
    return text;
}

}  // namespace relief
