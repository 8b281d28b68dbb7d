#include "framework/course/check/verdict_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "framework/core/base/error.h"
#include "framework/core/base/folded_text.h"

namespace relief::check {
namespace {

using nlohmann::ordered_json;

ordered_json as_json(const Verdict& check) {
    const FoldedText parts = unfolded_text(check.details);
    return {{"name", check.name},       {"outcome", name_of(check.outcome)},
            {"found", check.found},     {"details", parts.shown},
            {"further", parts.folded},  {"waits_for", check.waits_for},
            {"look_at", check.look_at}, {"view", check.view},
            {"hidden", check.hidden},   {"of_words", check.of_words}};
}

Verdict check_from(const ordered_json& json) {
    Verdict check{outcome_of(json.at("outcome").get<std::string>()), json.at("found")};
    check.name = json.at("name");
    check.details = json.value("details", "");
    check.waits_for = json.value("waits_for", TaskIds());
    check.look_at = json.at("look_at");
    check.view = json.at("view");
    check.hidden = json.at("hidden");
    check.of_words = json.value("of_words", false);
    return check;
}

}  // namespace

ordered_json as_json(const TaskVerdict& task) {
    ordered_json json = {{"id", task.id},           {"title", task.title}, {"file", task.file},
                         {"points", task.points()}, {"of", task.of},       {"waiting", task.waiting_points()},
                         {"mistake", task.mistake}, {"hint", task.hint},   {"checks", ordered_json::array()}};
    if (task.hidden_checks > 0) json["hidden_checks"] = task.hidden_checks, json["not_tested"] = task.not_tested;
    if (task.optional) json["optional"] = true;
    for (const Verdict& check : task.checks) json["checks"].push_back(as_json(check));
    return json;
}

TaskVerdict task_from(const ordered_json& json) {
    TaskVerdict task{.id = json.at("id"), .title = json.at("title"), .file = json.at("file"), .of = json.at("of")};
    task.mistake = json.at("mistake");
    task.hint = json.at("hint");
    task.optional = json.value("optional", false);
    for (const ordered_json& check : json.at("checks")) task.checks.push_back(check_from(check));
    const double points = json.at("points");
    const bool is_plain = task.id.find_first_not_of("0123456789.") == std::string::npos;  // else it is not ours
    if (task.of < 0 || !(std::abs(points - task.points()) < 1e-6))
        throw Error(fmt::format("task {} has {} of {} points, with {} of {} checks passed", is_plain ? task.id : "?",
                                points, task.of,
                                std::count_if(task.checks.begin(), task.checks.end(),
                                              [](const Verdict& one) { return one.outcome == Outcome::passed; }),
                                task.checks.size()));
    return task;
}

}  // namespace relief::check
