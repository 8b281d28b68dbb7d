#include "framework/course/pages/check_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "framework/core/base/folded_text.h"
#include "framework/core/base/text.h"
#include "framework/course/pages/check_figures.h"
#include "framework/course/pages/page.h"

namespace relief::pages {
namespace {

/// `told` holds the probes of the task whose colours an unfolded check above explains.
Fields fields_of(const Manifest& manifest, const check::Verdict& result, std::set<std::string>& told) {
    const CheckInfo& check = manifest.check(result.name);
    const bool passed = result.outcome == check::Outcome::passed;
    const bool is_open = !passed && result.outcome != check::Outcome::unproven && check::reason_to_wait(result).empty();
    Fields pictures = check_figures(manifest, check, result.drawn, result.expected, DrawnBy::reader, result.related);
    if (is_open) tell_once(pictures, told);
    return {{"name", check.name},
            {"quoted", quoted_for_shell(check.name)},
            {"badge", badge(result.outcome)},
            {"open", is_open},
            {"why", passed || is_open ? "" : result.found},
            {"found_is", result.outcome == check::Outcome::broken ? "message" : "found"},
            {"found", result.found},
            {"allowed", check.reason},
            {"pictures", check.shot.calls ? Value() : Value(std::move(pictures))}};
}

/// Returns the distinct messages of compilers, each with its source line. They stand before all tasks: one mistake in a
/// file keeps every check from drawing.
List messages_of(const std::vector<check::TaskVerdict>& tasks) {
    List messages;
    std::set<std::string> seen;
    for (const check::TaskVerdict& task : tasks)
        for (const check::Verdict& result : task.checks) {
            const FoldedText parts = unfolded_text(result.details);
            if (result.details.empty() || !seen.insert(result.found + parts.shown).second) continue;
            messages.push_back(Fields{{"message", result.found},
                                      {"details", parts.shown},
                                      {"more", parts.folded.empty() ? "" : more_messages(parts.folded.size())},
                                      {"folded", join(parts.folded, "\n")}});
        }
    return messages;
}

}  // namespace

std::string look_at(const check::Verdict& result) {
    if (result.look_at.empty() && result.outcome == check::Outcome::broken)
        return result.found.find("not finite") != std::string::npos
                   ? "a root of a negative number, or 0 / 0: nothing can be measured before the values are finite"
                   : "fix what the message names";
    return result.look_at;
}

std::string check_page(const LabEntry& lab, const Manifest& manifest, const std::vector<check::TaskVerdict>& tasks,
                       const std::string& driver) {
    List shown;
    for (const check::TaskVerdict& task : tasks) {
        List checks, groups;
        std::vector<Fields> waiting(task.checks.size());
        std::set<std::string> hints, told;  // each once in a task
        for (size_t i = 0; i < task.checks.size(); ++i) {
            const check::Verdict& result = task.checks[i];
            Fields fields = fields_of(manifest, result, told);
            const bool is_told =
                result.outcome >= check::Outcome::wrong && result.outcome != check::Outcome::unfinished;
            const std::string hint = look_at(result);
            const bool is_new = is_told && !hint.empty() && hints.insert(hint).second;
            fields["look_at"] = is_new ? rows(with_code(hint).list) : Value();
            if (check::reason_to_wait(result).empty())
                checks.push_back(std::move(fields));
            else
                waiting[i] = std::move(fields);
        }
        for (const auto& [reason, indices] : check::waiting_checks(task)) {
            List folded;
            for (const size_t i : indices) folded.push_back(std::move(waiting[i]));
            groups.push_back(Fields{{"reason", check::count_of_checks(indices.size()) + ": " + reason},
                                    {"checks", std::move(folded)}});
        }
        List not_tested;
        for (const std::string& demand : task.not_tested) not_tested.push_back(Fields{{"demand", demand}});
        shown.push_back(Fields{{"id", task.id},
                               {"title", task.title},
                               {"file", task.file},
                               {"hint", rows(with_code(task.hint).list)},
                               {"points", check::points_text(task)},
                               {"not_tested", std::move(not_tested)},
                               {"worst", badge(task.worst())},
                               {"checks", std::move(checks)},
                               {"blocked", std::move(groups)}});
    }
    const std::string number = lab.two_digits(),
                      reached = check::points_text(std::round(check::sum_of(tasks).points * 100) / 100);
    return render(Page{.title = fmt::format("Lab {}: {} of {} points", number, reached, manifest.points()),
                       .body = "check",
                       .styles = {"badge", "checks", "figures", "check"},
                       .scripts = {"wipe", "checks"}},
                  {{"number", number},
                   {"title", manifest.title},
                   {"points", reached},
                   {"said", check::points_text(tasks)},
                   {"of", manifest.points()},
                   {"messages", messages_of(tasks)},
                   {"tasks", std::move(shown)},
                   {"driver", driver}});
}

}  // namespace relief::pages
