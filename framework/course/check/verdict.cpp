#include "framework/course/check/verdict.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "framework/core/base/error.h"
#include "framework/core/base/text.h"

namespace relief::check {
namespace {

constexpr const char* outcome_names[] = {"passed", "unproven", "waiting",     "wrong",         "unfinished",
                                         "broken", "crashed",  "out_of_time", "out_of_memory", "machine"};

/// "1.2", "1.2, 1.3 and 1.4"
std::string names_of(const TaskIds& tasks) {
    if (tasks.size() < 2) return fmt::format("{}", fmt::join(tasks, ""));
    return fmt::format("{} and {}", fmt::join(tasks.begin(), tasks.end() - 1, ", "), tasks.back());
}

}  // namespace

const char* name_of(Outcome outcome) { return outcome_names[int(outcome)]; }

Outcome outcome_of(const std::string& name) {
    for (int i = 0; i < int(std::size(outcome_names)); ++i)
        if (name == outcome_names[i]) return Outcome(i);
    throw Error("unknown outcome '" + name + "'");
}

bool has_failed(Outcome outcome) {
    return outcome >= Outcome::wrong && outcome != Outcome::unfinished && outcome != Outcome::machine;
}

namespace {

/// Returns the outcome of each share of a task's points, see TaskVerdict::points(). The last one is that of the task's
/// words, if it has any: the worst outcome of their checks.
std::vector<Outcome> shares_of(const TaskVerdict& task) {
    std::vector<Outcome> shares;
    std::optional<Outcome> words;
    for (const Verdict& check : task.checks) {
        if (check.of_words)
            words = std::max(words.value_or(check.outcome), check.outcome);
        else
            shares.push_back(check.outcome);
    }
    if (words) shares.push_back(*words);
    return shares;
}

/// Returns the points of the shares with this outcome.
double points_of(const TaskVerdict& task, Outcome outcome) {
    const std::vector<Outcome> shares = shares_of(task);
    if (shares.empty()) return 0;
    return task.of * double(std::count(shares.begin(), shares.end(), outcome)) / double(shares.size());
}

/// Returns "4.25 of 5 points", or the range of points that are still possible.
std::string range_text(double least, double waiting, int of, const char* kind = "") {
    const std::string most = waiting > 0 ? " to " + points_text(least + waiting) : "";
    return fmt::format("{}{} of {} {}points", points_text(least), most, of, kind);
}

}  // namespace

double TaskVerdict::points() const { return points_of(*this, Outcome::passed); }

Outcome TaskVerdict::worst() const {
    Outcome outcome = Outcome::passed;
    for (const Verdict& check : checks) outcome = std::max(outcome, check.outcome);
    return outcome;
}

double TaskVerdict::waiting_points() const {
    return points_of(*this, Outcome::waiting) + points_of(*this, Outcome::unproven);
}

TaskVerdict::Share TaskVerdict::share_of(const Verdict& check) const {
    const std::vector<Outcome> shares = shares_of(*this);
    const auto has_words = [](const Verdict& one) { return one.of_words; };
    const auto words = std::count_if(checks.begin(), checks.end(), has_words);
    const double most = double(of) / double(shares.size()) / (check.of_words ? double(words) : 1);
    const Outcome outcome = check.of_words ? shares.back() : check.outcome;
    return {outcome == Outcome::passed ? most : 0, most};
}

TaskVerdict unjudged(const TaskInfo& task) {
    return {.id = task.id, .title = task.title, .file = task.file, .of = task.points, .optional = task.optional};
}

PointSum sum_of(const std::vector<TaskVerdict>& tasks, bool optional) {
    PointSum sum;
    for (const TaskVerdict& task : tasks)
        if (task.optional == optional)
            sum.points += task.points(), sum.waiting += task.waiting_points(), sum.of += task.of;
    return sum;
}

std::string points_text(const TaskVerdict& task) {
    std::set<std::string> others;
    for (const Verdict& check : task.checks) others.insert(check.waits_for.begin(), check.waits_for.end());
    const double waiting = task.waiting_points();
    const std::string range = range_text(task.points(), waiting, task.of, task.optional ? "optional " : "");
    if (others.empty()) return range;
    const std::string points = points_text(points_of(task, Outcome::waiting));
    return fmt::format("{}: {} {} for {}", range, points, points == "1" ? "waits" : "wait",
                       names_of({others.begin(), others.end()}));
}

std::string points_text(const std::vector<TaskVerdict>& tasks) {
    int hidden = 0;
    for (const TaskVerdict& task : tasks) hidden += task.hidden_checks;
    const PointSum all = sum_of(tasks), more = sum_of(tasks, true);
    const std::string optional =
        more.of > 0 ? ", and " + range_text(more.points, more.waiting, more.of, "optional ") : "";
    if (hidden == 0) return range_text(all.points, all.waiting, all.of) + optional;
    return fmt::format("{}{}; {} more check{} the rest when it is graded",
                       range_text(all.points, all.waiting, all.of, "public "), optional, hidden,
                       hidden == 1 ? " decides" : "s decide");
}

std::string reason_to_wait(const Verdict& result) {
    if (result.outcome == Outcome::waiting)  // the sentence is about several checks
        return result.found.starts_with("waits ") ? "waiting " + result.found.substr(6) : result.found;
    return result.outcome == Outcome::broken && !result.details.empty()
               ? "nothing can be drawn: see the message of the compiler"
               : "";
}

std::vector<WaitingChecks> waiting_checks(std::span<const Verdict* const> results) {
    std::vector<WaitingChecks> groups;
    for (size_t i = 0; i < results.size(); ++i) {
        const std::string reason = results[i] ? reason_to_wait(*results[i]) : "";
        if (reason.empty()) continue;
        auto group =
            std::find_if(groups.begin(), groups.end(), [&](const WaitingChecks& one) { return one.reason == reason; });
        if (group == groups.end()) group = groups.insert(groups.end(), {reason});
        group->checks.push_back(i);
    }
    return groups;
}

std::vector<WaitingChecks> waiting_checks(const TaskVerdict& task) {
    std::vector<const Verdict*> results;
    for (const Verdict& check : task.checks) results.push_back(&check);
    return waiting_checks(results);
}

std::string count_of_checks(size_t count) { return fmt::format("{} check{}", count, count == 1 ? "" : "s"); }

std::string waits_text(const TaskIds& tasks, const char* state) {
    return fmt::format("waits for {} {}, which {} not {} yet", tasks.size() > 1 ? "tasks" : "task", names_of(tasks),
                       tasks.size() > 1 ? "are" : "is", state);
}

std::string points_text(double points) { return plain(std::round(points * 100) / 100); }

}  // namespace relief::check
