#include "framework/staff/proof/self_test.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <mutex>

#include "framework/core/base/file.h"
#include "framework/core/base/log.h"
#include "framework/core/base/parallel.h"
#include "framework/core/base/paths.h"
#include "framework/course/task/starter.h"

namespace relief::grade {
namespace {

Submission submission_of(CourseFiles files) {
    Submission submission;
    submission.files = std::move(files);
    return submission;
}

/// Lists all checks whose outcome is not `expected`.
std::string told(const check::TaskVerdict& task, check::Outcome expected) {
    std::string text;
    for (const check::Verdict& check : task.checks)
        if (check.outcome != expected)
            text += fmt::format("; {}: {} ({})", check.name, name_of(check.outcome), check.found);
    return text;
}

/// Returns `count` evenly spaced indices from 0 to size - 1; all if `count` is 0. A manifest lists entries by task, so
/// these belong to different tasks.
std::vector<size_t> sample_of(size_t size, int count) {
    const size_t wanted = count > 0 ? std::min(size, size_t(count)) : size;
    std::vector<size_t> places;
    for (size_t i = 0; i < wanted; ++i) places.push_back((2 * i + 1) * size / (2 * wanted));
    return places;
}

class Test {
public:
    Test(const LabEntry& lab, const LabGrader& grader, SelfTestOptions options)
        : lab_(lab), grader_(grader), options_(options), solution_(solution_files(grader.manifest())) {}

    SelfTest run() {
        const auto begin = std::chrono::steady_clock::now();
        const Manifest& manifest = grader_.manifest();
        if (!manifest.tasks.empty() && manifest.equivalents.size() < fewest_equivalents)
            wrong(fmt::format("there are {} [[equivalent]]: a lab with tasks has {} at least",
                              manifest.equivalents.size(), fewest_equivalents));
        struct Step {
            std::string name;
            std::function<void()> take;
        };
        std::vector<Step> steps = {{"starter", [this] { starter(); }}};
        // Constructing the grader already checked that the solution gets all points: a sample skips this step.
        if (options_.sample == 0) steps.insert(steps.begin(), {"solution", [this] { solution(); }});
        const std::vector<size_t> mistakes = sample_of(manifest.mistakes.size(), options_.sample);
        const std::vector<size_t> equivalents = sample_of(manifest.equivalents.size(), options_.sample);
        for (const size_t i : mistakes)
            steps.push_back({manifest.mistakes[i].id, [&, i] { mistake(manifest.mistakes[i]); }});
        const std::vector<size_t> examples = sample_of(manifest.examples.size(), options_.sample);
        for (const size_t i : examples)
            if (const ExampleInfo& info = manifest.examples[i]; !info.edits.empty())
                steps.push_back({"words of task " + info.task, [&] { example(info); }});
        for (const size_t i : equivalents)
            steps.push_back({manifest.equivalents[i].id, [&, i] { equivalent(manifest.equivalents[i]); }});
        result_.left_out =
            int(manifest.mistakes.size() + manifest.equivalents.size()) - int(mistakes.size() + equivalents.size());
        Progress progress(int(steps.size()));
        parallel_each(steps.size(), unsigned(options_.jobs), [&](size_t i) {
            {
                const std::lock_guard lock(mutex_);
                progress.next("lab " + lab_.two_digits() + ", " + steps[i].name);
            }
            steps[i].take();
        });
        result_.checks = manifest.checks.size();
        result_.hidden_views = grader_.hidden_views();
        result_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        return result_;
    }

private:
    static constexpr size_t fewest_equivalents = 5;

    void wrong(const std::string& what) { result_.wrong.push_back(what); }

    LabMark mark_with(const std::vector<Edit>& edits) {
        CourseFiles files = edited(edits);
        files.insert(solution_.begin(), solution_.end());  // keeps the edited files
        return grader_.mark(submission_of(files), nullptr, options_.sample == 0);
    }

    void solution() {
        const LabMark mark = grader_.mark(submission_of(solution_));
        const std::lock_guard lock(mutex_);
        for (const check::TaskVerdict& task : mark.tasks)
            if (task.points() != task.of)
                wrong(
                    fmt::format("the solution of task {} loses points{}", task.id, told(task, check::Outcome::passed)));
    }

    void starter() {
        CourseFiles files;
        for (const auto& [name, text] : solution_) files[name] = check::starter_of(text, name);
        const LabMark mark = grader_.mark(submission_of(files));
        const std::lock_guard lock(mutex_);
        for (const check::TaskVerdict& task : mark.tasks)
            if (task.points() != 0)
                wrong(fmt::format("the starter of task {} gets points{}", task.id,
                                  told(task, check::Outcome::unfinished)));
    }

    /// Other tasks are correct, so they must pass. Only a check that declares a dependence on the task may fail.
    void look_at_others(const MistakeInfo& info, const LabMark& mark) {
        for (const check::TaskVerdict& task : mark.tasks) {
            if (task.id == info.task) continue;
            if (!task.mistake.empty())
                wrong(fmt::format("'{}' is of task {}, and '{}' is named at task {}, which is right", info.id,
                                  info.task, task.mistake, task.id));
            for (const check::Verdict& check : task.checks) {
                if (check.outcome != check::Outcome::passed &&
                    !grader_.manifest().check(check.name).depends_on(info.task))
                    wrong(fmt::format("'{}' fails '{}' of task {}: neither its needs nor its leans_on have {}", info.id,
                                      check.name, task.id, info.task));
            }
        }
    }

    void mistake(const MistakeInfo& info) {
        const LabMark mark = mark_with(info.edits);
        const std::lock_guard lock(mutex_);
        ++result_.mistakes;
        look_at_others(info, mark);
        for (const check::TaskVerdict& task : mark.tasks) {
            if (task.id != info.task) continue;
            if (!mark.graded() || task.points() == task.of)
                return wrong(fmt::format("'{}' is not caught{}", info.id, told(task, check::Outcome::unfinished)));
            ++result_.caught;
            if (options_.sample > 0) continue;
            const std::string& name = info.same_as.empty() ? info.id : info.same_as;
            if (task.mistake == name)
                ++result_.named;
            else
                wrong(fmt::format("'{}' is named '{}': give it same_as, or a check that tells them apart", info.id,
                                  task.mistake));
        }
    }

    void example(const ExampleInfo& info) {
        const check::Verdict said = grader_.words_of(info, edited(info.edits));
        const std::lock_guard lock(mutex_);
        ++result_.examples;
        if (said.outcome == check::Outcome::wrong && said.look_at.find(info.asks) != std::string::npos) return;
        wrong(fmt::format("task {} says \"{}\", and its example does not notice the edit ({}: {})", info.task,
                          info.asks, name_of(said.outcome), said.found));
    }

    void equivalent(const EquivalentInfo& info) {
        const LabMark mark = mark_with(info.edits);
        const std::lock_guard lock(mutex_);
        ++result_.equivalents;
        bool right = true;
        for (const check::TaskVerdict& task : mark.tasks) {
            if (task.points() == task.of) continue;
            right = false;
            wrong(fmt::format("'{}' is right, and loses points of task {}{}", info.id, task.id,
                              told(task, check::Outcome::passed)));
        }
        result_.right += right;
    }

    const LabEntry& lab_;
    const LabGrader& grader_;
    SelfTestOptions options_;
    CourseFiles solution_;
    std::mutex mutex_;
    SelfTest result_;
};

}  // namespace

SelfTest test_grader(const LabEntry& lab, const GradeSetup& setup, SelfTestOptions options) {
    Stage stage(setup.isolation);
    stage.add(lab);
    LabGrader grader(lab, stage, setup);
    grader.reuse_shaders();
    return Test(lab, grader, options).run();
}

}  // namespace relief::grade
