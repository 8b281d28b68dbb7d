#include "framework/course/check/judge.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

#include "framework/core/base/error.h"
#include "framework/core/base/text.h"
#include "framework/course/check/agreement.h"
#include "framework/course/task/task_text.h"

namespace relief::check {
namespace {

/// Returns whether a message has the name, not as a part of a longer one.
bool has_name(const std::string& message, const std::string& name) {
    for (size_t at = message.find(name); at != std::string::npos; at = message.find(name, at + 1)) {
        const size_t end = at + name.size();
        if ((at == 0 || !is_word_character(message[at - 1])) &&
            (end == message.size() || !is_word_character(message[end])))
            return true;
    }
    return false;
}

/// Returns whether a message comes from a compiler. It names the place itself, and all tasks of the file get it.
bool names_its_place(const Verdict& said) {
    const auto has = [&](const char* words) { return said.found.find(words) != std::string::npos; };
    return said.outcome == Outcome::broken && (has("shaders/") || has("labs/") || has("does not compile"));
}

/// Returns for each check the tasks that may have made it fail; empty if it did not fail.
std::vector<std::set<std::string>> suspects_of(const Manifest& manifest, const std::vector<Verdict>& said) {
    std::vector<std::set<std::string>> suspects(said.size());
    for (size_t i = 0; i < said.size(); ++i) {
        if (!has_failed(said[i].outcome)) continue;
        const CheckInfo& check = manifest.checks[i];
        if (!said[i].culprit.empty()) {
            suspects[i] = {said[i].culprit};
        } else {
            suspects[i] = {check.task};
            if (names_its_place(said[i])) continue;
            suspects[i].insert(check.needs.begin(), check.needs.end());
            suspects[i].insert(check.leans_on.begin(), check.leans_on.end());
        }
    }
    return suspects;
}

bool have_common(const std::set<std::string>& some, const TaskIds& others) {
    return std::any_of(others.begin(), others.end(), [&](const std::string& one) { return some.contains(one); });
}

/// Calls `take` with each subset of `size` tasks, in lexicographic order.
void for_each_set(const TaskIds& tasks, size_t size, const std::function<void(const TaskIds&)>& take) {
    std::vector<bool> is_in(tasks.size());
    std::fill(is_in.begin(), is_in.begin() + std::ptrdiff_t(size), true);
    do {
        TaskIds set;
        for (size_t i = 0; i < tasks.size(); ++i)
            if (is_in[i]) set.push_back(tasks[i]);
        take(set);
    } while (std::prev_permutation(is_in.begin(), is_in.end()));
}

using Sets = std::vector<TaskIds>;

bool contains(const TaskIds& tasks, const std::string& task) {
    return std::find(tasks.begin(), tasks.end(), task) != tasks.end();
}

/// Returns the smallest sets of tasks that explain all failures, in lexicographic order.
Sets smallest_sets(const Manifest& manifest, const std::vector<Verdict>& checks,
                   const std::vector<std::set<std::string>>& suspects) {
    TaskIds failing;
    for (const TaskInfo& task : manifest.tasks)
        for (size_t i = 0; i < checks.size(); ++i)
            if ((!suspects[i].empty() && manifest.checks[i].task == task.id) || checks[i].culprit == task.id) {
                failing.push_back(task.id);
                break;
            }
    Sets sets;
    for (size_t size = 1; size <= failing.size() && sets.empty(); ++size)
        for_each_set(failing, size, [&](const TaskIds& set) {
            if (std::all_of(suspects.begin(), suspects.end(),
                            [&](const auto& one) { return one.empty() || have_common(one, set); }))
                sets.push_back(set);
        });
    return sets;
}

/// Returns whether the task has checks that depend on no other task, and passes all of them.
bool is_right_alone(const Manifest& manifest, const std::vector<Verdict>& checks, const std::string& task) {
    bool any = false;
    for (size_t i = 0; i < checks.size(); ++i) {
        const CheckInfo& check = manifest.checks[i];
        if (check.task != task || !check.needs.empty() || !check.leans_on.empty()) continue;
        if (checks[i].outcome != Outcome::passed) return false;
        any = true;
    }
    return any;
}

/// Keeps the sets of which most tasks satisfy `is_better`.
void keep_best(Sets& sets, const std::function<bool(const std::string&)>& is_better) {
    if (sets.size() < 2 || !is_better) return;
    std::map<std::string, bool> known;
    size_t most = 0;
    std::vector<size_t> counts;
    for (const TaskIds& set : sets) {
        size_t& count = counts.emplace_back(0);
        for (const std::string& task : set) {
            if (!known.contains(task)) known[task] = is_better(task);
            count += known[task];
        }
        most = std::max(most, count);
    }
    Sets best;
    for (size_t i = 0; i < sets.size(); ++i)
        if (counts[i] == most) best.push_back(sets[i]);
    sets = std::move(best);
}

std::string as_sentence(const std::string& text) {
    return text + (text.ends_with('?') || text.ends_with('.') ? " " : ". ");
}

bool costs_points(Outcome outcome) { return outcome != Outcome::passed && outcome != Outcome::machine; }

constexpr const char* wrong_among_solutions = "wrong with the solution of the other tasks, too";

/// Lets a mistake cost points only in its own task, see judge_lab().
void judge_among_solutions(const Manifest& manifest, std::vector<Verdict>& checks, const Evidence& evidence) {
    if (!evidence.among_solutions) return;
    std::map<std::string, std::vector<size_t>> lost;  // by task
    bool depends_on_others = false;
    for (size_t i = 0; i < checks.size(); ++i) {
        if (!costs_points(checks[i].outcome)) continue;
        lost[manifest.checks[i].task].push_back(i);
        depends_on_others |= !manifest.checks[i].needs.empty() || !manifest.checks[i].leans_on.empty();
    }
    if (lost.size() < 2 && !depends_on_others) return;
    for (const auto& [check, outcome] : evidence.among_solutions(lost)) {
        Verdict& said = checks[check];
        // What was found is of the student's own drawing, or a fixed sentence.
        if (outcome == Outcome::passed)
            said = {outcome, "passed with the solution of the other tasks"};
        else if (outcome == Outcome::wrong && said.outcome != Outcome::wrong)
            said = {.outcome = outcome, .found = wrong_among_solutions, .view = said.view};
        said.is_own |= outcome != Outcome::passed && outcome == said.outcome;
    }
}

/// Fills in the hint of each check, and lets checks wait for the tasks that should be put right first.
void tell(const Manifest& manifest, std::vector<Verdict>& checks, const std::vector<Cause>& causes,
          const std::map<std::string, NamedMistake>& named) {
    // Tasks that get no usual cause. A failed call is evidence, which a usual cause may contradict. Later checks of a
    // task name details that the code may have right.
    std::set<std::string> hinted;
    for (size_t i = 0; i < checks.size(); ++i)
        if (manifest.checks[i].shot.calls && checks[i].outcome == Outcome::wrong && causes[i].first.empty())
            hinted.insert(manifest.checks[i].task);
    for (size_t i = 0; i < checks.size(); ++i) {
        const CheckInfo& check = manifest.checks[i];
        Verdict& said = checks[i];
        if (const TaskIds& first = causes[i].first; !first.empty()) {
            said.outcome = Outcome::waiting;
            said.found = waits_text(first, "right");
            said.details.clear();
            said.waits_for = first;
            said.look_at = fmt::format("put task {} right first", fmt::join(first, " and task "));
            said.related = {};
        } else if (said.outcome != Outcome::wrong) {
            said.look_at.clear();
        } else if (!causes[i].together.empty()) {
            const std::string measured = said.look_at.empty() ? "" : capitalized(said.look_at);
            said.look_at =
                fmt::format("{} is wrong, or several of these: no check tells which",
                            capitalized("task " + fmt::format("{}", fmt::join(causes[i].together, " or task "))));
            for (const std::string& more : {measured, capitalized(said.relation)})
                if (!more.empty()) said.look_at = as_sentence(said.look_at) + more;
        } else if (named.contains(check.task)) {
            said.look_at = capitalized(said.relation);  // the task's hint tells the rest
        } else {
            const bool is_first = hinted.insert(check.task).second;
            said.look_at = is_first || !said.look_at.empty() ? hint_of(check, said) : capitalized(said.relation);
        }
    }
}

}  // namespace

std::optional<Verdict> judge_text(const Manifest& manifest, const CheckInfo& check, const TaskTexts& texts,
                                  const OtherShaders& others) {
    const TaskInfo& own = manifest.task(check.task);
    const std::string& file = own.file;
    if (const std::string why = texts.refused ? texts.refused(file) : ""; !why.empty())
        return Verdict{Outcome::broken, fmt::format("{} is {}", file, why)};
    const std::optional<std::string> text = texts.read(file);
    if (!text) return Verdict{Outcome::unfinished, fmt::format("there is no {}", file)};
    if (const auto fault = fault_of_task(*text, file)) {
        Verdict said{Outcome::broken, Error({file, fault->line}, fault->message).what()};
        said.details = fault->quote;
        return said;
    }
    if (is_shader(file))
        if (const std::string beyond = broken_rule(*text, others); !beyond.empty())
            return Verdict{Outcome::broken, fmt::format("{} {}", file, beyond)};
    if (const std::string missing_function = missing_text(*text, own); !missing_function.empty())
        return Verdict{Outcome::broken, missing_function};
    const auto is_written = [&](const std::string& task) {
        const auto other = texts.read(manifest.task(task).file);
        return other && !is_unfinished(*other, manifest.task(task));
    };
    if (!is_written(check.task)) return Verdict{Outcome::unfinished, "not written yet"};
    TaskIds missing;
    for (const std::string& task : check.needs)
        if (!is_written(task)) missing.push_back(task);
    if (missing.empty()) return {};
    Verdict waits{Outcome::waiting, waits_text(missing, "written")};
    waits.waits_for = missing;
    return waits;
}

void tell_leftover(const Manifest& manifest, const CheckInfo& check, const TaskTexts& texts, Verdict& said) {
    if (said.outcome != Outcome::wrong) return;
    const auto text = texts.read(manifest.task(check.task).file);
    if (const int line = text ? line_of_unfinished(*text, manifest.task(check.task)) : 0)
        said.found += fmt::format("; line {} still calls unfinished()", line);
}

std::string culprit_of(const Manifest& manifest, const std::string& message, const TaskTexts& texts) {
    for (const TaskInfo& task : manifest.tasks) {
        const auto text = texts.read(task.file);
        if (!text) continue;
        for (const std::string& function : missing_functions(*text, task))
            if (has_name(message, parse_signature(function).name)) return task.id;
    }
    for (const TaskInfo& task : manifest.tasks) {
        const size_t found = message.find(task.file + ":");
        if (found == std::string::npos) continue;
        const size_t begin = found + task.file.size() + 1, end = message.find_first_not_of("0123456789", begin);
        const auto line = parse_int(message.substr(begin, end == std::string::npos ? end : end - begin));
        const auto text = texts.read(task.file);
        return line && *line > 0 && text ? task_at_line(*text, manifest.tasks, task.file, size_t(*line)) : "";
    }
    return {};
}

std::vector<Cause> causes_of(const Manifest& manifest, const std::vector<Verdict>& checks,
                             const std::function<bool(const std::string& task)>& is_recognised) {
    const std::vector<std::set<std::string>> suspects = suspects_of(manifest, checks);
    std::vector<Cause> causes(checks.size());
    Sets sets = smallest_sets(manifest, checks, suspects);
    if (sets.empty()) return causes;
    keep_best(sets, is_recognised);
    keep_best(sets, [&](const std::string& task) { return !is_right_alone(manifest, checks, task); });
    const auto in_all = [&](const std::string& task) {
        return std::all_of(sets.begin(), sets.end(), [&](const TaskIds& set) { return contains(set, task); });
    };
    const auto in_some = [&](const std::string& task) {
        return std::any_of(sets.begin(), sets.end(), [&](const TaskIds& set) { return contains(set, task); });
    };
    // Wrong tasks with a failure that no other wrong task explains. The check of a wrong task waits only for certain
    // tasks, and a certain task keeps a failed check that waits for none. So waiting has no cycle.
    std::set<std::string> certain;
    for (size_t i = 0; i < checks.size(); ++i) {
        const std::string& own = manifest.checks[i].task;
        if (in_all(own) && suspects[i].contains(own) &&
            std::count_if(suspects[i].begin(), suspects[i].end(), in_some) == 1)
            certain.insert(own);
    }
    for (size_t i = 0; i < checks.size(); ++i) {
        const std::string& own = manifest.checks[i].task;
        bool any_wrong = false;
        TaskIds undecided;
        for (const TaskInfo& task : manifest.tasks) {
            if (!suspects[i].contains(task.id) || !in_some(task.id)) continue;
            any_wrong |= in_all(task.id);
            if (!in_all(task.id)) undecided.push_back(task.id);
            if (task.id != own && in_all(task.id) && (!in_some(own) || certain.contains(task.id)))
                causes[i].first.push_back(task.id);
        }
        if (any_wrong || undecided.empty()) continue;
        if (contains(undecided, own) && undecided.size() > 1)
            causes[i].together = undecided;
        else if (!contains(undecided, own))
            causes[i].first = undecided;
    }
    return causes;
}

std::vector<TaskVerdict> judge_lab(const Manifest& manifest, std::vector<Verdict> checks, const Evidence& evidence) {
    std::vector<bool> compared;  // whether the check's picture says something about its own task
    for (const Verdict& said : checks) compared.push_back(said.outcome == Outcome::passed);
    judge_among_solutions(manifest, checks, evidence);
    for (size_t i = 0; i < checks.size(); ++i) compared[i] = compared[i] || checks[i].outcome != Outcome::passed;
    const bool failed_machine =
        std::any_of(checks.begin(), checks.end(), [](const Verdict& said) { return said.outcome == Outcome::machine; });
    const auto recognise = [&](const std::string& task) {
        return evidence.recognise && !failed_machine ? evidence.recognise(task, checks, compared) : std::nullopt;
    };
    std::vector<Cause> causes =
        causes_of(manifest, checks, [&](const std::string& task) { return recognise(task).has_value(); });
    std::map<std::string, size_t> failures;  // by task: failures that it caused itself
    for (size_t i = 0; i < checks.size(); ++i) {
        compared[i] = compared[i] && causes[i].first.empty();
        if (compared[i] && has_failed(checks[i].outcome)) ++failures[manifest.checks[i].task];
        if (!checks[i].is_own) continue;
        // The task waits for no other, but its picture shows the mistakes of others, too. So a hint could be untrue.
        Verdict& said = checks[i];
        if (!causes[i].first.empty() && said.outcome == Outcome::wrong && said.found != wrong_among_solutions)
            said.found += std::string("; ") + wrong_among_solutions, said.look_at.clear(), said.relation.clear();
        causes[i] = {};
    }
    std::map<std::string, NamedMistake> named;
    for (const auto& [task, count] : failures)
        if (auto mistake = recognise(task)) {
            mistake->hint = told(mistake->hint, mistake->is_certain, count);
            named[task] = std::move(*mistake);
        }
    tell(manifest, checks, causes, named);
    std::vector<TaskVerdict> tasks;
    for (const TaskInfo& info : manifest.tasks) {
        TaskVerdict& task = tasks.emplace_back(unjudged(info));
        for (size_t i = 0; i < checks.size(); ++i) {
            const CheckInfo& check = manifest.checks[i];
            if (check.task != info.id) continue;
            Verdict& said = task.checks.emplace_back(std::move(checks[i]));
            said.index = i, said.name = check.name, said.hidden = check.hidden, said.of_words = bool(check.shot.calls);
        }
        if (task.checks.empty()) throw Error(fmt::format("{}: task {} has no check", manifest.title, info.id));
        if (const auto mistake = named.find(info.id); mistake != named.end())
            task.mistake = mistake->second.id, task.hint = mistake->second.hint;
    }
    return tasks;
}

std::string hint_of(const CheckInfo& check, const Verdict& said) {
    std::string hint = said.look_at;
    if (hint.empty() && !check.look_at.empty()) hint = "a usual cause lies here: " + check.look_at;
    if (said.relation.empty()) return hint;
    return hint.empty() ? capitalized(said.relation) : as_sentence(hint) + capitalized(said.relation);
}

}  // namespace relief::check
