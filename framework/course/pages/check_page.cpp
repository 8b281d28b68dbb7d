#include "framework/course/pages/check_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "framework/core/base/text.h"
#include "framework/core/context/context.h"
#include "framework/course/pages/check_figures.h"
#include "framework/course/pages/page.h"

namespace relief::pages {
namespace {

/// `told` holds the probes of the task whose colours an unfolded check above explains.
Fields fields_of(const Manifest& manifest, const check::CheckResult& result, std::set<std::string>& told) {
    const CheckInfo& check = *result.check;
    const bool passed = result.outcome == check::Outcome::passed;
    Fields pictures = check_figures(manifest, check, result.drawn, result.expected, DrawnBy::reader, result.related);
    if (!passed) tell_once(pictures, told);
    return {{"name", check.name},
            {"quoted", quoted_for_shell(check.name)},
            {"badge", badge(result.outcome)},
            {"open", !passed},
            {"found_is", result.outcome == check::Outcome::broken ? "message" : "found"},
            {"found", result.found},
            {"details", result.details},
            {"allowed", check.reason},
            {"pictures", std::move(pictures)}};
}

check::Outcome worst(const check::TaskResult& task) {
    check::Outcome outcome = check::Outcome::passed;
    for (const check::CheckResult& result : task.checks) outcome = std::max(outcome, result.outcome);
    return outcome;
}

}  // namespace

std::string look_at(const check::CheckResult& result) {
    if (result.look_at.empty() && result.outcome == check::Outcome::broken)
        return result.found.find("not finite") != std::string::npos
                   ? "a root of a negative number, or 0 / 0: nothing can be measured before the values are finite"
               : result.details.empty()
                   ? "fix what the message names"
                   : "fix what the message names; a missing ; stands at the end of the line before";
    return result.look_at;
}

std::string check_page(const LabEntry& lab, const Manifest& manifest, const std::vector<check::TaskResult>& tasks) {
    double points = 0;
    List shown;
    for (const check::TaskResult& task : tasks) {
        points += task.points();
        List checks;
        std::set<std::string> hints, told;  // each once in a task
        for (const check::CheckResult& result : task.checks) {
            Fields fields = fields_of(manifest, result, told);
            const bool is_told =
                result.outcome >= check::Outcome::wrong && result.outcome != check::Outcome::unfinished;
            const std::string hint = look_at(result);
            const bool is_new = is_told && !hint.empty() && hints.insert(hint).second;
            fields["look_at"] = is_new ? rows(with_code(hint).list) : Value();
            checks.push_back(std::move(fields));
        }
        shown.push_back(Fields{{"id", task.task->id},
                               {"title", task.task->title},
                               {"file", task.task->file},
                               {"points", check::points_text(task)},
                               {"worst", badge(worst(task))},
                               {"checks", std::move(checks)}});
    }
    const std::string number = lab.two_digits(), reached = check::points_text(std::round(points * 100) / 100);
    return render(Page{.title = fmt::format("Lab {}: {} of {} points", number, reached, manifest.points()),
                       .body = "check",
                       .styles = {"badge", "checks", "figures", "check"},
                       .scripts = {"wipe", "checks"}},
                  {{"number", number},
                   {"title", manifest.title},
                   {"points", reached},
                   {"of", manifest.points()},
                   {"tasks", std::move(shown)},
                   {"driver", describe_context().driver()}});
}

}  // namespace relief::pages
