#include "framework/course/window/menu_checks.h"

#include <fmt/format.h>

#include <algorithm>

#include "framework/core/base/error.h"
#include "framework/core/base/log.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/system.h"
#include "framework/core/base/text.h"
#include "framework/course/check/last_points.h"

namespace relief::window {
namespace fs = std::filesystem;

constexpr double longest_check = 5;  // seconds of processor time; a check takes less than one

void Checks::open(const LabEntry& lab, const Manifest& manifest) {
    lab_ = &lab;
    manifest_ = manifest;
    checker_.emplace(lab, manifest_);
    hints_.clear();
    results_.assign(manifest_.checks.size(), {});
    expected_.assign(manifest_.checks.size(), {});
    waiting_.assign(manifest_.checks.size(), true);
    ++version_;
    seen_ = last_look_ = files(lab, manifest_);
    saved_ = check::last_saved(manifest_);
    to_build_.clear();
}

Checks::Files Checks::files(const LabEntry& lab, const Manifest& manifest) {
    Files found;
    std::error_code ignored;  // a file that is missing for a moment is skipped in this look
    for (const fs::path& folder : {fs::path("shaders") / lab.folder, fs::path("shaders") / "common"})
        for (const auto& entry : fs::directory_iterator(course_root() / folder, ignored))
            found[entry.path()] = entry.last_write_time(ignored);
    for (const TaskInfo& task : manifest.tasks) {
        const fs::path file = course_root() / task.file;
        found[file] = fs::last_write_time(file, ignored);
    }
    return found;
}

bool Checks::look() {
    if (manifest_.checks.empty()) return false;
    Files now = files(*lab_, manifest_);
    const bool is_stable = now == last_look_;
    last_look_ = std::move(now);
    if (!is_stable || last_look_ == seen_) return false;
    for (const auto& [file, time] : last_look_)
        if (file.extension() == ".cpp" && seen_[file] != time) to_build_ = shown(file);
    seen_ = last_look_;
    saved_ = check::last_saved(manifest_);
    checker_.emplace(*lab_, manifest_);  // it has cached the lab's old shaders
    waiting_.assign(manifest_.checks.size(), true);
    hints_.clear();
    ++version_;
    return true;
}

bool Checks::pending() const { return std::find(waiting_.begin(), waiting_.end(), true) != waiting_.end(); }

void Checks::run_next(const std::string& first) {
    if (!pending()) return;
    const std::vector<size_t> order = check::checks_in_order(manifest_);
    size_t i = *std::find_if(order.begin(), order.end(), [&](size_t k) { return waiting_[k]; });
    for (size_t k = 0; k < waiting_.size(); ++k)
        if (waiting_[k] && manifest_.checks[k].name == first) i = k;
    waiting_[i] = false;
    const double begin = os::processor_seconds();
    const CheckInfo& check = manifest_.checks[i];
    ++version_;
    try {
        std::optional<Image> expected = expected_[i];
        if (!expected) {
            expected = check::expectation(*lab_, check);
            std::error_code ignored;
            if (check.against == "truth" || fs::exists(check::expectation_file(*lab_, check), ignored))
                expected_[i] = expected;
        }
        results_[i] = checker_->run(i, expected);
        check::tell_unproven(*lab_, check, *results_[i]);
    } catch (const std::exception& error) {  // rendering the expected picture, which a student's file can break
        results_[i] = check::Verdict{check::Outcome::broken, error.what()};
    }
    // The window does not answer while a check runs.
    if (const double seconds = os::processor_seconds() - begin; seconds > longest_check)
        for (size_t k = 0; k < waiting_.size(); ++k)
            if (waiting_[k] && (manifest_.checks[k].task == check.task || manifest_.checks[k].depends_on(check.task))) {
                check::Verdict late{check::Outcome::out_of_time,
                                    fmt::format("not tried, because '{}' took {:.0f} seconds: does a loop not end?",
                                                check.name, seconds)};
                checker_->keep(k, {late});
                results_[k] = std::move(late);
                waiting_[k] = false;
            }
    if (pending()) return;
    for (check::TaskVerdict& task : checker_->tasks()) {
        for (check::Verdict& said : task.checks) {
            check::tell_unproven(*lab_, manifest_.checks[said.index], said);
            results_[said.index] = std::move(said);
        }
        if (task.hint.empty()) continue;
        print_event(fmt::format("task {}, look at: {}", task.id, without_backticks(task.hint)));
        hints_[task.id] = std::move(task.hint);
    }
    check::keep_points(*lab_, tasks(), saved_);
    print_event("checks: " + points());
}

std::string Checks::progress() const {
    return fmt::format("{} of {}", std::count(waiting_.begin(), waiting_.end(), false), waiting_.size());
}

std::optional<check::Outcome> Checks::worst(const TaskInfo& task) const {
    for (size_t i = 0; i < results_.size(); ++i)
        if (manifest_.checks[i].task == task.id && !results_[i]) return {};
    return of(task).worst();
}

check::TaskVerdict Checks::of(const TaskInfo& task) const {
    check::TaskVerdict whole = check::unjudged(task);
    for (size_t i = 0; i < results_.size(); ++i) {
        if (manifest_.checks[i].task != task.id) continue;
        check::Verdict& check = whole.checks.emplace_back(check::Verdict{check::Outcome::unfinished});
        if (results_[i]) check.outcome = results_[i]->outcome, check.waits_for = results_[i]->waits_for;
    }
    return whole;
}

std::vector<check::TaskVerdict> Checks::tasks() const {
    std::vector<check::TaskVerdict> all;
    for (const TaskInfo& task : manifest_.tasks) all.push_back(of(task));
    return all;
}

std::string Checks::points() const { return check::points_text(tasks()); }

std::string Checks::hint(const TaskInfo& task) const {
    const auto found = hints_.find(task.id);
    return found == hints_.end() ? "" : found->second;
}

}  // namespace relief::window
