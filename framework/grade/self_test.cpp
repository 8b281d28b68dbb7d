#include "framework/grade/self_test.h"

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <thread>

#include "framework/base/file.h"
#include "framework/base/log.h"
#include "framework/base/paths.h"
#include "framework/grade/starter.h"

namespace relief {
namespace {

Submission submission_of(std::map<std::string, std::string> files) {
    Submission submission;
    submission.files = std::move(files);
    return submission;
}

std::string told(const TaskMark& task) {
    std::string text;
    for (const CheckMark& check : task.checks)
        text += fmt::format("; {}: {} ({})", check.name, name_of(check.outcome), check.found);
    return text;
}

class Test {
public:
    Test(const LabEntry& lab, const LabGrader& grader) : lab_(lab), grader_(grader) {
        for (const std::string& file : task_files(grader.manifest())) solution_[file] = read_file(course_root() / file);
    }

    SelfTest run(int jobs) {
        const auto begin = std::chrono::steady_clock::now();
        solution(), starter();
        const std::vector<MistakeInfo>& mistakes = grader_.manifest().mistakes;
        std::atomic<size_t> next = 0;
        Progress progress(int(mistakes.size()));
        const auto work = [&] {
            for (size_t i = next++; i < mistakes.size(); i = next++) {
                {
                    const std::lock_guard lock(mutex_);
                    progress.next("lab " + lab_.two_digits() + ", " + mistakes[i].id);
                }
                mistake(mistakes[i]);
            }
        };
        {
            std::vector<std::jthread> threads;
            for (int i = 1; i < jobs; ++i) threads.emplace_back(work);
            work();
        }
        result_.checks = grader_.manifest().checks.size(), result_.hidden_views = grader_.hidden_views();
        result_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        return result_;
    }

private:
    void wrong(const std::string& what) { result_.wrong.push_back(what); }

    void solution() {
        for (const TaskMark& task : grader_.mark(submission_of(solution_)).tasks)
            if (task.points != task.of)
                wrong(fmt::format("the solution of task {} loses points{}", task.id, told(task)));
    }

    void starter() {
        std::map<std::string, std::string> files;
        for (const auto& [name, text] : solution_) files[name] = starter_of(text, name);
        for (const TaskMark& task : grader_.mark(submission_of(files)).tasks)
            if (task.points != 0) wrong(fmt::format("the starter of task {} gets points{}", task.id, told(task)));
    }

    void mistake(const MistakeInfo& info) {
        auto files = solution_;
        for (const auto& [name, text] : edited(info.edits)) files[name] = text;
        const LabMark mark = grader_.mark(submission_of(files));
        const std::lock_guard lock(mutex_);
        ++result_.mistakes;
        for (const TaskMark& task : mark.tasks) {
            if (task.id != info.task) continue;
            if (!mark.graded() || task.points == task.of)
                return wrong(fmt::format("'{}' is not caught{}", info.id, told(task)));
            ++result_.caught;
            const std::string& name = info.same_as.empty() ? info.id : info.same_as;
            if (task.mistake == name)
                ++result_.named;
            else
                wrong(fmt::format("'{}' is named '{}': give it same_as, or a check that tells them apart", info.id,
                                  task.mistake));
        }
    }

    const LabEntry& lab_;
    const LabGrader& grader_;
    std::map<std::string, std::string> solution_;
    std::mutex mutex_;
    SelfTest result_;
};

}  // namespace

SelfTest test_grader(const LabEntry& lab, const GradeSetup& setup, int jobs) {
    Stage stage(setup.isolation);
    stage.add(lab);
    const LabGrader grader(lab, stage, setup);
    return Test(lab, grader).run(jobs);
}

}  // namespace relief
