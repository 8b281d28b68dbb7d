// Every lab as a course: solutions pass, starters say that they are unfinished, and each known mistake is caught. That
// correct variants pass is `relief grade --self-test`.
#include <gtest/gtest.h>

#include <map>
#include <regex>

#include "framework/base/file.h"
#include "framework/base/paths.h"
#include "framework/grade/check.h"
#include "framework/grade/overlay.h"
#include "framework/grade/starter.h"
#include "tests/labs/task_variant.h"
#include "tests/support.h"

namespace relief {

static void PrintTo(const LabEntry& lab, std::ostream* stream) { *stream << lab.folder; }

namespace {

class Course : public testing::TestWithParam<LabEntry> {
protected:
    Manifest manifest_ = load_manifest(GetParam());

    /// The course's own labs have tasks; a new one need not.
    bool is_of_the_course() const { return GetParam().number < 20; }
    std::set<std::string> task_files() const {
        std::set<std::string> files;
        for (const TaskInfo& task : manifest_.tasks) files.insert(task.file);
        return files;
    }
    CourseFiles starters() const {
        CourseFiles files;
        for (const std::string& file : task_files()) files[file] = starter_of(read_file(course_root() / file), file);
        return files;
    }
};

bool is_shader(const std::string& file) { return !file.ends_with(".cpp"); }

TEST_P(Course, HasTasksChecksAndMistakes) {
    if (!is_of_the_course()) GTEST_SKIP() << "a lab of someone's own";
    EXPECT_GE(manifest_.tasks.size(), GetParam().number == 1 ? 2u : 3u);
    EXPECT_GE(manifest_.mistakes.size(), 8u);
    for (const TaskInfo& task : manifest_.tasks) {
        const std::string text = read_file(course_root() / task.file);
        EXPECT_TRUE(contains(text, "TASK " + task.id + " (" + std::to_string(task.points) + " points)")) << task.id;
        EXPECT_TRUE(is_unfinished(starter_of(text, task.file), task.id)) << task.id;
        EXPECT_FALSE(is_unfinished(text, task.id)) << task.id;
        bool is_public = false;
        for (const CheckInfo& check : manifest_.checks) is_public |= check.task == task.id && !check.hidden;
        EXPECT_TRUE(is_public) << "a student cannot check task " << task.id;
    }
}

TEST_P(Course, HasCorrectVariantsOfEachTaskThatAreOtherPrograms) {
    if (!is_of_the_course()) GTEST_SKIP() << "a lab of someone's own";
    EXPECT_GE(manifest_.equivalents.size(), 5u);
    for (const TaskInfo& task : manifest_.tasks)
        EXPECT_TRUE(std::any_of(manifest_.equivalents.begin(), manifest_.equivalents.end(),
                                [&](const EquivalentInfo& equivalent) { return equivalent.task == task.id; }))
            << task.id;
    const auto code_of = [](const std::string& text) {
        static const std::regex no_code("//[^\n]*|\\s+");
        return std::regex_replace(text, no_code, "");
    };
    std::map<CourseFiles, std::string> seen;
    for (const std::string& file : task_files())
        seen[{{file, code_of(read_file(course_root() / file))}}] = "the solution";
    for (const EquivalentInfo& equivalent : manifest_.equivalents) {
        CourseFiles code;
        for (const auto& [file, text] : edited(equivalent.edits)) code[file] = code_of(text);
        const auto [same, is_new] = seen.emplace(code, equivalent.id);
        EXPECT_TRUE(is_new) << equivalent.id << " is the same program as " << same->second;
    }
}

TEST_P(Course, TheSolutionPassesEveryCheck) {
    for (const CheckInfo& check : manifest_.checks) {
        const CheckResult result = run_check(GetParam(), manifest_, check, expectation(GetParam(), check));
        EXPECT_EQ(result.outcome, Outcome::passed) << check.name << ": " << result.found;
    }
}

TEST_P(Course, AStarterIsUnfinishedInEveryCheckAndPaintsTheChequer) {
    if (manifest_.tasks.empty()) GTEST_SKIP() << "a lab of someone's own";
    Expectations expected;
    for (const CheckInfo& check : manifest_.checks) expected[check.name] = expectation(GetParam(), check);
    const CourseOverlay overlay(starters());
    for (const CheckInfo& check : manifest_.checks)
        EXPECT_EQ(run_check(GetParam(), manifest_, check, expected[check.name]).outcome, Outcome::unfinished)
            << check.name;
    // A shader's hole is seen in the lab's first picture.
    if (!std::any_of(manifest_.tasks.begin(), manifest_.tasks.end(),
                     [](const auto& task) { return is_shader(task.file); }))
        return;
    Shot shot;
    shot.size = {160, 120}, shot.camera = manifest_.camera;
    const Image picture = take(*make_lab(GetParam(), shot), shot);
    size_t magenta = 0;
    for (size_t i = 0; i < picture.pixel_count(); ++i) {
        const float* const pixel = &picture.values[i * 3];
        magenta += std::abs(pixel[0] - 0.85f) < 0.01f && pixel[1] < 0.01f && std::abs(pixel[2] - 0.85f) < 0.01f;
    }
    EXPECT_GT(magenta, picture.pixel_count() / 50);
}

TEST_P(Course, EveryKnownMistakeFailsACheckOfItsTask) {
    Expectations expected;
    for (const CheckInfo& check : manifest_.checks) expected[check.name] = expectation(GetParam(), check);
    for (const MistakeInfo& mistake : manifest_.mistakes) {
        const CourseFiles files = edited(mistake.edits);
        const bool in_shaders =
            std::all_of(files.begin(), files.end(), [](const auto& file) { return is_shader(file.first); });
        std::string kept;
        bool caught = false;
        const auto judge = [&](const std::string& name, bool passed, const std::string& found) {
            caught |= !passed;
            kept += "\n  " + name + ": " + found;
        };
        if (in_shaders) {
            const CourseOverlay overlay(files);
            for (const CheckInfo& check : manifest_.checks)
                if (check.task == mistake.task) {
                    const CheckResult result = run_check(GetParam(), manifest_, check, expected[check.name]);
                    judge(check.name, result.outcome == Outcome::passed, result.found);
                    EXPECT_FALSE(result.outcome == Outcome::broken && contains(result.found, "glsl"))
                        << mistake.id << " does not compile: " << result.found;
                }
        } else {
            for (const auto& [name, outcome, found] : check_with_task(GetParam(), mistake.task, files, expected))
                judge(name, outcome == "passed", found);
        }
        EXPECT_FALSE(kept.empty()) << mistake.id << ": nothing was checked";
        EXPECT_TRUE(caught) << mistake.id << " passes every check of task " << mistake.task << kept;
    }
}

INSTANTIATE_TEST_SUITE_P(Labs, Course, testing::ValuesIn(registry()),
                         [](const auto& lab) { return "Lab" + lab.param.folder; });

}  // namespace
}  // namespace relief
