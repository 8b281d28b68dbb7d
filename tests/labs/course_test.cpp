// Every lab as a course: solutions pass, starters report that they are unfinished, and each known mistake is caught.
// `relief grade --self-test` tests that correct variants pass.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <regex>
#include <set>

#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/text.h"
#include "framework/core/context/context.h"
#include "framework/core/gl/gl.h"
#include "framework/course/check/calls.h"
#include "framework/course/check/fingerprints.h"
#include "framework/course/check/kept_lab.h"
#include "framework/course/manifest/paths.h"
#include "framework/course/task/code_definitions.h"
#include "framework/course/task/starter.h"
#include "framework/course/task/task_text.h"
#include "framework/staff/grade/fingerprint_maker.h"
#include "framework/staff/grade/mistake_names.h"
#include "framework/staff/grade/overlay.h"
#include "framework/staff/grade/transplant.h"
#include "framework/staff/grade/variation.h"
#include "tests/labs/task_variant.h"
#include "tests/support.h"

namespace relief {

static void PrintTo(const LabEntry& lab, std::ostream* stream) { *stream << lab.folder; }

namespace {

class Course : public testing::TestWithParam<LabEntry> {
protected:
    Manifest manifest_ = load_manifest(GetParam());

    /// Only the grader makes programs with the hidden calls of C++ tasks: `relief grade --self-test` tests those.
    void SetUp() override {
        std::erase_if(manifest_.checks, [](const CheckInfo& check) {
            return check.hidden && check.shot.calls && !is_shader(check.shot.calls.file);
        });
    }

    check::Fingerprints known_mistakes() const {
        const std::string text = grade::public_fingerprints(GetParam(), [](const std::string&) {});
        return check::parse_fingerprints(text, check::fingerprints_file(GetParam()), manifest_);
    }

    struct Used {
        double share;
        std::string check;
    };
    static inline std::vector<Used> used_;

    /// Prints the ten checks whose solutions use the largest share of a limit.
    static void TearDownTestSuite() {
        std::sort(used_.begin(), used_.end(), [](const Used& a, const Used& b) { return a.share > b.share; });
        for (size_t i = 0; i < std::min<size_t>(10, used_.size()); ++i)
            std::printf("%.0f %% of a limit: %s\n", 100 * used_[i].share, used_[i].check.c_str());
        used_.clear();
    }

    /// Returns whether the lab is one of the course's own, which all have tasks.
    bool is_of_the_course() const { return GetParam().number < 20; }
    std::set<std::string> task_files() const {
        std::set<std::string> files;
        for (const TaskInfo& task : manifest_.tasks) files.insert(task.file);
        return files;
    }
    /// Returns the pictures that the checks compare with, made once for all tests. Precondition: no CourseOverlay.
    const Expectations& expectations() const {
        static std::map<std::string, Expectations> by_lab;
        const auto [place, is_new] = by_lab.try_emplace(GetParam().folder);
        if (is_new)
            for (const CheckInfo& check : manifest_.checks)
                place->second[check.name] = check::expectation(GetParam(), check);
        return place->second;
    }
    /// Returns those of the checks of `manifest`.
    Expectations expectations_of(const Manifest& manifest) const {
        Expectations some;
        for (const CheckInfo& check : manifest.checks) some[check.name] = expectations().at(check.name);
        return some;
    }
    grade::CourseFiles starters() const {
        grade::CourseFiles files;
        for (const std::string& file : task_files())
            files[file] = check::starter_of(read_file(course_root() / file), file);
        return files;
    }
};

/// Returns the text of a task, from the comment in its file, in one line.
std::string words_of(const TaskInfo& task) {
    std::istringstream lines(read_file(course_root() / task.file));
    std::string words;
    bool is_inside = false;
    for (std::string line; std::getline(lines, line);) {
        is_inside = (is_inside && line.starts_with("//") && !line.starts_with("//(")) ||
                    line.starts_with("// TASK " + task.id + " ");
        if (is_inside) words += line.substr(2);
    }
    return std::regex_replace(words, std::regex(" +"), " ");
}

// Functions that pass a variable between stages cannot be called without their view.
TEST_P(Course, TheWordsOfEachTaskHaveExamples) {
    if (!is_of_the_course()) GTEST_SKIP() << "a lab of someone's own";
    static const std::set<std::string> without = {"18.5"};
    std::map<std::string, int> count;
    for (const ExampleInfo& example : manifest_.examples) {
        ++count[example.task];
        EXPECT_TRUE(example.hidden || !example.edits.empty())
            << "task " << example.task << ": no edit in staff/grading.toml breaks \"" << example.asks << '"';
        EXPECT_TRUE(words_of(manifest_.task(example.task)).find(example.asks) != std::string::npos)
            << "task " << example.task << " does not say \"" << example.asks << '"';
    }
    for (const TaskInfo& task : manifest_.tasks) EXPECT_EQ(count[task.id] == 0, without.contains(task.id)) << task.id;
}

// Otherwise students learn only from the mark what they could have tested. Hidden calls remain, so that no table of the
// public ones gets all points.
TEST_P(Course, HalfOfTheCallsOfEachTaskArePublic) {
    std::map<std::string, size_t> all, known;
    for (const ExampleInfo& example : manifest_.examples) {
        all[example.task] += example.calls.size();
        known[example.task] += example.hidden ? 0 : example.calls.size();
    }
    for (const auto& [task, count] : all) EXPECT_GE(2 * known[task], count) << task;
}

TEST_P(Course, TheHandoutSaysOnceThatThereAreHiddenChecks) {
    const std::string words =
        "`relief check` shows the public checks. When your work is graded, more checks decide the rest. The text of "
        "each "
        "task has every demand.";
    const std::string lines = read_file(course_root() / "labs" / GetParam().folder / "README.md"),
                      text = std::regex_replace(lines, std::regex("\n"), " ");
    const size_t first = text.find(words);
    ASSERT_NE(first, text.npos) << "labs/README.md has the words";
    EXPECT_EQ(text.find(words, first + 1), text.npos);
}

TEST_P(Course, TheHandoutStatesTimeNeedsAndWhatMayBeLeftOut) {
    if (!is_of_the_course()) GTEST_SKIP() << "a lab of someone's own";
    const std::string lines = read_file(course_root() / "labs" / GetParam().folder / "README.md"),
                      text = std::regex_replace(lines, std::regex("\n"), " ");
    ASSERT_GT(manifest_.hours, 0);
    EXPECT_TRUE(contains(text, "**Time.** " + effort_text(manifest_) + "  **Begin here.**")) << effort_text(manifest_);
    for (const std::string& chapter : manifest_.leave_out)
        EXPECT_TRUE(contains(lines, "\n## " + chapter + "\n")) << chapter;
    for (const TaskInfo& task : manifest_.tasks) {
        const size_t row = lines.find(fmt::format("\n| {} | {} | ", task.id, task.points));
        ASSERT_NE(row, lines.npos) << task.id;
        EXPECT_EQ(contains(lines.substr(row + 1, lines.find('\n', row + 1) - row), "(optional) |"), task.optional)
            << task.id;
    }
}

// Otherwise a student who leaves an optional task out cannot check another one.
TEST_P(Course, NoPublicCheckOfATaskNeedsAnOptionalOne) {
    for (const CheckInfo& check : manifest_.checks) {
        if (check.hidden || manifest_.task(check.task).optional) continue;
        for (const TaskInfo& other : manifest_.tasks)
            EXPECT_FALSE(other.optional && check.depends_on(other.id)) << check.name << " depends on " << other.id;
    }
}

TEST(CoursePaths, HaveWhatEachLabNeedsBeforeIt) {
    std::vector<Manifest> all;
    for (const LabEntry& lab : registry()) all.push_back(load_manifest(lab));
    std::map<std::string, const Manifest*> by_number;
    for (size_t i = 0; i < all.size(); ++i) by_number[registry()[i].two_digits()] = &all[i];
    for (const auto& [number, manifest] : by_number)
        for (const std::string& need : manifest->needs) {
            ASSERT_TRUE(by_number.contains(need)) << number << " needs " << need;
            EXPECT_LT(need, number);
            EXPECT_FALSE(by_number[need]->elective) << number << " needs " << need;
            for (const auto& [path, week] : manifest->weeks) {
                const auto before = by_number[need]->weeks.find(path);
                ASSERT_NE(before, by_number[need]->weeks.end()) << path << ": " << number << " needs " << need;
                EXPECT_LE(before->second, week) << path << ": " << number << " needs " << need;
            }
        }
}

// The instructor's guide has the paths as tables: "| 1 | 01, 04, 05 | 6 |".
TEST(CoursePaths, StandInTheGuideWithTheHoursOfEachWeek) {
    const std::string guide = read_file(course_root() / "labs/staff/README.md");
    std::vector<Manifest> all;
    std::vector<const Manifest*> labs;
    for (const LabEntry& lab : registry()) all.push_back(load_manifest(lab));
    for (const Manifest& manifest : all) labs.push_back(&manifest);
    for (const CoursePath& path : course_paths) {
        double hours = 0;
        std::string table;
        const std::vector<CourseWeek> weeks = weeks_of(path, labs);
        for (size_t i = 0; i < weeks.size(); ++i) {
            std::vector<std::string> numbers;
            for (const size_t lab : weeks[i].labs) numbers.push_back(registry()[lab].two_digits());
            ASSERT_FALSE(numbers.empty()) << path.name << ": nothing to do in week " << i + 1;
            table += fmt::format("| {} | {} | {} |", i + 1, join(numbers, ", "), weeks[i].hours) + "\n";
            hours += weeks[i].hours;
        }
        EXPECT_TRUE(contains(guide, table)) << path.name << "\n" << table;
        EXPECT_TRUE(contains(guide, fmt::format("`--path {}`, {}", path.name, hours_text(hours)))) << hours;
    }
}

TEST_P(Course, HasTasksChecksAndMistakes) {
    if (!is_of_the_course()) GTEST_SKIP() << "a lab of someone's own";
    EXPECT_GE(manifest_.tasks.size(), GetParam().number == 1 ? 2u : 3u);
    EXPECT_GE(manifest_.mistakes.size(), 8u);
    for (const TaskInfo& task : manifest_.tasks) {
        const std::string text = read_file(course_root() / task.file);
        EXPECT_TRUE(contains(
            text, "TASK " + task.id + " (" + std::to_string(task.points) + (task.points == 1 ? " point)" : " points)")))
            << task.id;
        EXPECT_TRUE(check::is_unfinished(check::starter_of(text, task.file), task)) << task.id;
        EXPECT_FALSE(check::is_unfinished(text, task)) << task.id;
        bool is_public = false, reads_the_picture = false;
        for (const CheckInfo& check : manifest_.checks) {
            is_public |= check.task == task.id && !check.hidden;
            reads_the_picture |= check.task == task.id && !check.shot.probe;
        }
        EXPECT_TRUE(is_public) << "a student cannot check task " << task.id;
        EXPECT_TRUE(reads_the_picture) << "the picture of task " << task.id << " can be wrong, and its probes right";
    }
}

TEST_P(Course, HasDistinctCorrectVariantsOfEachTask) {
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
    std::map<grade::CourseFiles, std::string> seen;
    for (const std::string& file : task_files())
        seen[{{file, code_of(read_file(course_root() / file))}}] = "the solution";
    for (const EquivalentInfo& equivalent : manifest_.equivalents) {
        grade::CourseFiles code;
        for (const auto& [file, text] : grade::edited(equivalent.edits)) code[file] = code_of(text);
        const auto [same, is_new] = seen.emplace(code, equivalent.id);
        EXPECT_TRUE(is_new) << equivalent.id << " is the same program as " << same->second;
    }
}

TEST_P(Course, TheManifestListsTheFunctionsThatEachStarterLeavesUnfinished) {
    for (const std::string& file : task_files()) {
        const std::string starter = check::starter_of(read_file(course_root() / file), file);
        std::map<std::string, std::vector<std::string>> asked;
        for (const check::TaskPart& part : check::task_parts(starter))
            for (const CodeDefinition& one : definitions_of(part.text).list)
                if (one.kind == CodeDefinition::function && one.called.contains("unfinished"))
                    asked[part.task].push_back(one.signature.text());
        for (const TaskInfo& task : manifest_.tasks)
            if (task.file == file && is_of_the_course()) {
                EXPECT_EQ(task.functions, asked[task.id]) << task.id;
            }
    }
}

TEST_P(Course, TheSolutionPassesEveryCheck) {
    check::LabChecker checker(GetParam(), manifest_);
    for (size_t i = 0; i < manifest_.checks.size(); ++i) {
        const CheckInfo& check = manifest_.checks[i];
        const check::Verdict result = checker.run(i, check::expectation(GetParam(), check));
        EXPECT_EQ(result.outcome, check::Outcome::passed) << check.name << ": " << result.found;
        const double used = check::judge(manifest_, check, result.drawn, result.expected).used;
        used_.push_back({used, check.task + " " + check.name});
        // Leaves a third of each limit, because another rasteriser may have an error 1.5 times as large.
        if (is_of_the_course() && is_software_renderer()) {
            EXPECT_LE(used, 2.0 / 3) << check.name << ": " << result.found;
        }
    }
}

// Otherwise a check's result would depend on the checks before it.
TEST_P(Course, AKeptLabDrawsTheBitsOfNewOnes) {
    check::KeptLab kept(GetParam());
    for (const CheckInfo& check : manifest_.checks) {
        const Image expected = draw_shot(*check::make_drawer(GetParam(), check.shot), check.shot);
        EXPECT_EQ(draw_shot(kept.drawer_of(check.shot), check.shot).values, expected.values) << check.name;
    }
}

// Otherwise a student would learn this only from the mark.
TEST_P(Course, TheStudentsChecksRejectAShaderThatReachesBeyondItsTask) {
    for (const std::string& file : task_files()) {
        if (!is_shader(file)) continue;
        const grade::CourseOverlay overlay(
            grade::CourseFiles{{file, read_file(course_root() / file) + "#define main mine\n"}});
        check::LabChecker checker(GetParam(), manifest_);
        for (size_t i = 0; i < manifest_.checks.size(); ++i) {
            if (manifest_.task(manifest_.checks[i].task).file != file) continue;
            const check::Verdict result = checker.run(i, {});
            EXPECT_EQ(result.outcome, check::Outcome::broken);
            EXPECT_EQ(result.found, file + " defines 'main', which the lab's shaders use");
        }
    }
}

// Otherwise some seeds give views that no lab draws, and their checks have no hidden view.
TEST_P(Course, HiddenViewsStayWithinTheKnobs) {
    for (const VaryInfo& vary : manifest_.vary) {
        if (vary.knob == "picture_size") continue;  // a factor, not a knob
        std::vector<std::string> values = vary.choices;
        if (values.empty()) values = {fmt::format("{}", vary.low), fmt::format("{}", vary.high)};
        for (const std::string& value : values) {
            Shot shot;
            shot.set = {{vary.knob, value}};
            EXPECT_NO_THROW(make_lab(GetParam(), shot)) << vary.knob << " " << value;
        }
    }
}

// Otherwise a submission that stores the picture of a public check would pass. Excludes checks whose picture has the
// same value everywhere, such as whether edges agree, or the kind of a map.
TEST_P(Course, AHiddenViewDiffersFromTheKnownCheck) {
    const grade::Variation variation(manifest_, GetParam().folder, "words", 0);
    for (const CheckInfo& check : manifest_.checks) {
        if (check.hidden || check.shot.calls) continue;
        const Image known = draw_shot(*make_lab(GetParam(), check.shot), check.shot);
        const size_t channels = size_t(known.channels);
        bool is_even = true;
        for (size_t i = channels; i < known.values.size(); ++i)
            is_even = is_even && known.values[i] == known.values[i - channels];
        if (is_even) continue;
        const Shot varied = variation.vary(check.shot);
        EXPECT_NE(known.values, draw_shot(*make_lab(GetParam(), varied), varied).values)
            << check.task << " '" << check.name << "': " << grade::view_text(varied);
    }
}

TEST_P(Course, AStarterIsUnfinishedInEveryCheckAndPaintsTheChequer) {
    if (manifest_.tasks.empty()) GTEST_SKIP() << "a lab of someone's own";
    const grade::CourseOverlay overlay(starters());
    for (const CheckInfo& check : manifest_.checks)  // without a picture to compare with: nothing is drawn
        EXPECT_EQ(check::run_check(GetParam(), manifest_, check, {}).outcome, check::Outcome::unfinished) << check.name;
    // An unfinished task in a shader is visible in the lab's first picture.
    if (!std::any_of(manifest_.tasks.begin(), manifest_.tasks.end(),
                     [](const auto& task) { return is_shader(task.file); }))
        return;
    Shot shot;
    shot.size = {160, 120}, shot.camera = manifest_.camera;
    const Image picture = render_shot(*make_lab(GetParam(), shot), shot);
    size_t magenta = 0;
    for (size_t i = 0; i < picture.pixel_count(); ++i) {
        const float* const pixel = &picture.values[i * 3];
        magenta += std::abs(pixel[0] - 0.85f) < 0.01f && pixel[1] < 0.01f && std::abs(pixel[2] - 0.85f) < 0.01f;
    }
    EXPECT_GT(magenta, picture.pixel_count() / 50);
}

bool has_cpp(const std::vector<Edit>& edits) {
    return std::any_of(edits.begin(), edits.end(), [](const Edit& edit) { return !is_shader(edit.file); });
}

/// Returns a sample of mistakes or variants in shaders. Leaves out those in C++ unless tests_all(): each needs a build.
template <class Thing>
std::vector<const Thing*> sample_by_edits(const std::vector<Thing>& things, size_t count) {
    std::vector<const Thing*> wanted;
    for (const Thing& thing : things)
        if (!has_cpp(thing.edits) || tests_all()) wanted.push_back(&thing);
    return sample_of(wanted, count);
}

/// The verdicts on all checks about a mistake in one task, and samples of their pictures.
struct Said {
    std::vector<check::Verdict> verdicts;
    check::Samples samples;
};

/// Returns the tasks that each check waits for, found like in `relief check`, from the checks of `manifest` only.
std::vector<check::TaskIds> waits(const Manifest& manifest, const check::Fingerprints& fingerprints, const Said& said) {
    const auto named = check::name_mistakes(fingerprints, manifest, said.verdicts, said.samples);
    std::vector<check::TaskIds> first;
    for (const check::Cause& cause :
         check::causes_of(manifest, said.verdicts, [&](const std::string& task) { return named.contains(task); }))
        first.push_back(cause.first);
    return first;
}

/// Expects that a mistake changes only its own task's part of a file. Then with_one_task() gives the file with the
/// mistake for that task, and the solution for every other task.
void expect_one_changed_part(const grade::CourseFiles& files, const Manifest& manifest, const MistakeInfo& mistake) {
    for (const auto& [file, text] : files) {
        const std::string solution = read_file(course_root() / file);
        for (const TaskInfo& task : manifest.tasks) {
            if (task.file != file) continue;
            EXPECT_EQ(grade::with_one_task(solution, text, manifest.tasks, task),
                      task.id == mistake.task ? text : solution)
                << mistake.id << " is of task " << mistake.task << ", and changes task " << task.id;
        }
    }
}

// Tests all mistakes in shaders until a check of their task catches them, and one of them in all checks of the lab.
// Tests one of the mistakes in C++. `relief test --all` tests all of them in all checks. A mistake costs
// points only in its own task. The grader draws a task among the solutions of all others. `relief check` has no
// solutions, so other checks wait.
TEST_P(Course, EveryKnownMistakeFailsChecksOfItsTaskAndOthersWait) {
    const Expectations& expected = expectations();
    const check::Fingerprints fingerprints = known_mistakes();
    // Public checks come first.
    Manifest students = manifest_;
    std::erase_if(students.checks, [](const CheckInfo& check) { return check.hidden; });
    const auto expect_others_wait = [&](const Manifest& manifest, const Said& said, const MistakeInfo& mistake) {
        const std::vector<check::TaskIds> first = waits(manifest, fingerprints, said);
        for (size_t i = 0; i < manifest.checks.size(); ++i) {
            const CheckInfo& check = manifest.checks[i];
            if (said.verdicts[i].outcome == check::Outcome::passed) continue;
            EXPECT_EQ(first[i], check.task == mistake.task ? check::TaskIds() : check::TaskIds{mistake.task})
                << mistake.id << " in '" << check.name << "' of task " << check.task << ", "
                << (manifest.checks.size() == manifest_.checks.size() ? "with" : "without")
                << " hidden checks: " << said.verdicts[i].found;
        }
    };
    std::vector<const MistakeInfo*> all, in_cpp;
    for (const MistakeInfo& mistake : manifest_.mistakes) (has_cpp(mistake.edits) ? in_cpp : all).push_back(&mistake);
    // The claim that other tasks wait needs all checks of the lab. For all mistakes of all labs they take minutes.
    const std::vector<const MistakeInfo*> drawn_in_all_checks = sample_of(all, 1);
    for (const MistakeInfo* one : sample_of(in_cpp, 1)) all.push_back(one);
    for (const MistakeInfo* one : all) {
        const MistakeInfo& mistake = *one;
        const grade::CourseFiles files = grade::edited(mistake.edits);
        expect_one_changed_part(files, manifest_, mistake);
        std::string kept;
        bool caught = false;
        const auto judge = [&](const std::string& name, bool passed, const std::string& found) {
            caught |= !passed;
            kept += "\n  " + name + ": " + found;
        };
        if (!has_cpp(mistake.edits)) {
            const grade::CourseOverlay overlay(files);
            const bool in_all_checks = std::ranges::count(drawn_in_all_checks, one) > 0;
            Said said;
            for (size_t i = 0; i < manifest_.checks.size(); ++i) {
                const CheckInfo& check = manifest_.checks[i];
                if (!in_all_checks && (caught || check.task != mistake.task)) continue;
                const check::Verdict result = check::run_check(GetParam(), manifest_, check, expected.at(check.name));
                said.verdicts.push_back({result.outcome, result.found, result.culprit});
                if (const auto places = fingerprints.checks.find(i); places != fingerprints.checks.end())
                    said.samples[i] = check::sample_at(result.drawn, result.found, places->second.values);
                EXPECT_FALSE(result.outcome == check::Outcome::broken && contains(result.found, "glsl"))
                    << mistake.id << " does not compile: " << result.found;
                if (check.task == mistake.task)
                    judge(check.name, result.outcome == check::Outcome::passed, result.found);
            }
            if (in_all_checks) {
                expect_others_wait(manifest_, said, mistake);
                said.verdicts.resize(students.checks.size());
                expect_others_wait(students, said, mistake);
            }
        } else {
            for (const VariantCheck& check : check_variant(GetParam(), files, expected)) {
                const bool passes = check.outcome == "passed", is_own = check.task == mistake.task;
                if (is_own) judge(check.name, passes, check.found);
                EXPECT_TRUE(passes || (check.outcome == "waiting") != is_own)
                    << mistake.id << " in '" << check.name << "' of task " << check.task << ": " << check.found;
            }
        }
        EXPECT_FALSE(kept.empty()) << mistake.id << ": nothing was checked";
        EXPECT_TRUE(caught) << mistake.id << " passes every check of task " << mistake.task << kept;
    }
}

// Otherwise a submission that is right in probes only loses nothing. Leaves out mistakes in C++ unless tests_all():
// each needs a build.
TEST_P(Course, AKnownMistakeOfEachTaskFailsACheckOfItsPicture) {
    Expectations expected;
    for (const CheckInfo& check : manifest_.checks)
        if (tests_all() || !check.shot.probe) expected[check.name] = check::expectation(GetParam(), check);
    const auto fails = [&](const MistakeInfo& mistake) {
        const grade::CourseFiles files = grade::edited(mistake.edits);
        std::set<std::string> failed;
        if (has_cpp(mistake.edits)) {
            for (const VariantCheck& check : check_variant(GetParam(), files, expected))
                if (check.outcome != "passed") failed.insert(check.name);
        } else {
            const grade::CourseOverlay overlay(files);
            for (const CheckInfo& check : manifest_.checks)
                if (check.task == mistake.task && !check.shot.probe && failed.empty() &&
                    check::run_check(GetParam(), manifest_, check, expected[check.name]).outcome !=
                        check::Outcome::passed)
                    failed.insert(check.name);
        }
        return std::ranges::any_of(manifest_.checks, [&](const CheckInfo& check) {
            return check.task == mistake.task && !check.shot.probe && failed.contains(check.name);
        });
    };
    for (const TaskInfo& task : manifest_.tasks) {
        std::vector<const MistakeInfo*> tested;
        for (const MistakeInfo& mistake : manifest_.mistakes)
            if (mistake.task == task.id && (!has_cpp(mistake.edits) || tests_all())) tested.push_back(&mistake);
        EXPECT_TRUE(tested.empty() || std::ranges::any_of(tested, [&](const auto* mistake) { return fails(*mistake); }))
            << "no known mistake of task " << task.id << " fails a check of its picture";
    }
}

// Tests the students' course: with the pictures of the handout, and without hidden checks.
TEST_P(Course, OnlyKnownMistakesAreNamed) {
    if (known_mistakes().mistakes.empty()) GTEST_SKIP() << "the lab has no known mistakes";
    const std::string grading = "labs/" + GetParam().folder + "/staff/grading.toml";
    Manifest students = manifest_;
    std::erase_if(students.checks, [](const CheckInfo& check) { return check.hidden; });
    const Expectations expected = expectations_of(students);
    struct TaskSaid {
        bool failed = false;
        std::string named = {};
    };
    const auto check = [&](const std::vector<Edit>& edits) {
        std::map<std::string, TaskSaid> said;
        grade::CourseFiles files = grade::edited(edits);
        if (std::all_of(files.begin(), files.end(), [](const auto& file) { return is_shader(file.first); })) {
            const grade::CourseOverlay overlay(files);
            check::LabChecker checker(GetParam(), students);
            for (const size_t i : check::checks_in_order(students))
                checker.run(i, expected.at(students.checks[i].name));
            for (const check::TaskVerdict& task : checker.tasks()) said[task.id] = {task.points() < task.of, task.hint};
        } else {
            files[grading] = "";
            for (const VariantCheck& one : check_variant(GetParam(), files, expected)) {
                said[one.task].failed |= one.outcome != "passed";
                said[one.task].named = one.mistake;
            }
        }
        return said;
    };
    size_t seen = 0, named = 0, unseen = 0;
    std::string others;
    for (const MistakeInfo* mistake : sample_by_edits(manifest_.mistakes, 1)) {
        const MistakeInfo& first = mistake->same_as.empty() ? *mistake : manifest_.mistake(mistake->same_as);
        for (const auto& [task, said] : check(mistake->edits)) {
            if (task != mistake->task) {
                EXPECT_EQ(said.named, "") << "at task " << task << ", which is right: " << mistake->id;
                continue;
            }
            ++(said.failed ? seen : unseen);
            // Mistakes that no public check distinguishes have one joined hint.
            const bool is_right = contains(said.named, grade::hint_with_same(manifest_, first));
            named += is_right;
            if (said.failed && !is_right) others += "\n  " + mistake->id + " is named '" + said.named + "'";
        }
    }
    for (const EquivalentInfo* equivalent : sample_by_edits(manifest_.equivalents, 0))
        for (const auto& [task, said] : check(equivalent->edits))
            EXPECT_EQ(said.named, "") << "at task " << task << ": " << equivalent->id << " is correct";
    fmt::print("lab {}: {} known mistakes fail a public check, {} of them named; {} fail none{}\n",
               GetParam().two_digits(), seen, named, unseen, others);
    EXPECT_GE(double(named), 0.9 * double(seen)) << others;
}

/// Returns the lines of a task file without the marks of regions. Each has the task that it belongs to ("" before the
/// first task).
std::vector<std::pair<std::string, std::string>> lines_by_task(const std::string& text) {
    static const std::regex region("[ \t]*//[()].*"), heading("// TASK ([0-9.]+) \\(.*");
    std::vector<std::pair<std::string, std::string>> lines;
    std::string task;
    for (const std::string& line : split(text, '\n')) {
        std::smatch named;
        if (std::regex_match(line, named, heading)) task = named[1];
        if (!std::regex_match(line, region)) lines.emplace_back(task, line);
    }
    return lines;
}

/// Returns `text` with the starter of one task and the solutions of all others.
std::string starter_of_task(const std::string& text, const std::string& file, const std::string& task) {
    std::string before, own, after;
    for (const auto& [of, line] : lines_by_task(text)) (of == task ? own : own.empty() ? before : after) += line + '\n';
    return before + check::starter_of(own, file) + after;
}

/// The versions of a wrong result, besides unfinished(): near the right value, far from it in both directions, and NaN.
constexpr int wrong_versions = 4;
std::string not_yet() {
    std::string text = "const float no_number = uintBitsToFloat(0x7fc00000u);\n";
    for (const char* type : {"float", "vec2", "vec3", "vec4", "mat3", "mat2x3", "mat2x4"})
        text += fmt::format(
            "{0} not_yet({0} v) {{\n"
            "    {0} one = {0}(1.0);\n"
            "    if (u_wrong == 0) return unfinished(v);\n"
            "    return u_wrong == 1 ? 0.5 * v + 0.3 * one : u_wrong == 2 ? 3.0 * v + 2.0 * one\n"
            "         : u_wrong == 3 ? -40.0 * v - 2.0 * one : no_number * one;\n"
            "}}\n",
            type);
    for (const char* type : {"int", "ivec2"})
        text += fmt::format("{0} not_yet({0} v) {{ return u_wrong == 0 ? unfinished(v) : u_wrong * v + 1; }}\n", type);
    return text;
}

/// The uniform that selects the starter of a task, by the task's place in the manifest. Each task has its own: a
/// program in which it is not active cannot depend on the task.
std::string selector_of(size_t task) { return "u_starter_" + std::to_string(task); }

/// Returns a task file that also contains every task's starter. Uniforms select them: see selector_of(). So a lab's
/// programs are compiled once for all starters. Precondition: each block of a solution is the whole body of a function.
std::string with_starters(const std::string& text, const std::vector<TaskInfo>& tasks) {
    std::string result, solution, starter;
    std::string* part = &result;
    for (const auto& [task, line] : lines_by_task(text)) {
        const std::string word = line.substr(std::min(line.find_first_not_of(' '), line.size()));
        if (word == "//[solution") {
            part = &solution;
        } else if (word == "//]starter") {
            part = &starter;
        } else if (word == "//]") {
            const auto is_own = [&, id = task](const TaskInfo& info) { return info.id == id; };
            const auto at = std::find_if(tasks.begin(), tasks.end(), is_own) - tasks.begin();
            // Renames the call, so that the text does not look unfinished.
            starter = std::regex_replace(starter, std::regex("\\bunfinished\\("), "not_yet(");
            result += "if (" + selector_of(size_t(at)) + ") {\n" + starter + "}\n" + solution;
            solution.clear(), starter.clear(), part = &result;
        } else {
            *part += (part == &starter ? word.substr(3) : line) + '\n';
        }
    }
    return result;
}

/// Returns the file that all task files include, with what with_starters() uses: a task itself may have no uniforms.
std::string unfinished_with_selectors(const std::string& text, size_t tasks) {
    std::string result = text;
    for (size_t i = 0; i < tasks; ++i) result += "uniform bool " + selector_of(i) + ";\n";
    return result + "uniform int u_wrong;\n" + not_yet();
}

/// Sets the uniforms of with_starters() in every program that has them, whenever a lab binds it. Selects no starter at
/// first.
class StarterInUse {
public:
    explicit StarterInUse(size_t tasks) : before_(glad_glUseProgram) {
        real_ = before_, glad_glUseProgram = use_program;
        selectors_.clear(), selected_.reset(), reached_.clear(), wrong_ = 0;
        for (size_t i = 0; i < tasks; ++i) selectors_.push_back(selector_of(i));
    }
    ~StarterInUse() { glad_glUseProgram = before_; }
    StarterInUse(const StarterInUse&) = delete;
    StarterInUse& operator=(const StarterInUse&) = delete;
    void select(size_t task, int wrong) { selected_ = task, wrong_ = wrong; }
    void select_none() { selected_.reset(); }
    /// Returns the tasks that programs bound since the last call can depend on.
    std::set<size_t> take_reached() { return std::exchange(reached_, {}); }

private:
    static void GLAD_API_PTR use_program(GLuint program) {
        real_(program);
        if (program == 0) return;
        for (size_t i = 0; i < selectors_.size(); ++i) {
            const GLint place = glGetUniformLocation(program, selectors_[i].c_str());
            if (place < 0) continue;
            glUniform1i(place, selected_ == i);
            reached_.insert(i);
        }
        if (const GLint place = glGetUniformLocation(program, "u_wrong"); place >= 0) glUniform1i(place, wrong_);
    }
    static inline PFNGLUSEPROGRAMPROC real_ = nullptr;
    static inline std::vector<std::string> selectors_;
    static inline std::optional<size_t> selected_;
    static inline std::set<size_t> reached_;
    static inline int wrong_ = 0;
    PFNGLUSEPROGRAMPROC before_;
};

/// Returns whether a known mistake in the shader of a task fails a check.
bool is_failed_by_mistake(const LabEntry& lab, const Manifest& manifest, const std::string& task,
                          const CheckInfo& check, const std::optional<Image>& expected) {
    return std::any_of(manifest.mistakes.begin(), manifest.mistakes.end(), [&](const MistakeInfo& mistake) {
        if (mistake.task != task || !is_shader(mistake.edits.front().file)) return false;
        const grade::CourseOverlay overlay(grade::edited(mistake.edits));
        return check::run_check(lab, manifest, check, expected).outcome != check::Outcome::passed;
    });
}

// A check must wait only for tasks that it needs. It must not fail while a task that it needs is missing. If the cause
// of a failure is another task, the student must be sent to that task.
TEST_P(Course, ChecksNeedExactlyTheirDeclaredTasks) {
    Manifest blind = manifest_;  // draws even if needed tasks are missing
    // Added checks declare all tasks, because a picture may take any of them.
    std::erase_if(blind.checks, [](const CheckInfo& check) { return check.added; });
    for (CheckInfo& check : blind.checks) check.needs.clear();
    const Expectations expected = expectations_of(blind);
    std::map<std::string, std::set<std::string>> needs, leans_on;  // by check
    grade::CourseFiles shaders;
    for (const std::string& file : task_files())
        if (is_shader(file)) shaders[file] = with_starters(read_file(course_root() / file), manifest_.tasks);
    const std::string unfinished = "shaders/common/unfinished.glsl";
    shaders[unfinished] = unfinished_with_selectors(read_file(course_root() / unfinished), manifest_.tasks.size());
    {
        const grade::CourseOverlay overlay(shaders);
        StarterInUse starter(manifest_.tasks.size());
        for (const CheckInfo& check : blind.checks) {
            const auto run = [&] { return check::run_check(GetParam(), blind, check, expected.at(check.name)); };
            const check::Verdict solution = run();
            EXPECT_EQ(solution.outcome, check::Outcome::passed)
                << check.name << " by the solutions: " << solution.found;
            for (const size_t i : starter.take_reached()) {  // the picture cannot depend on other tasks
                const std::string& task = manifest_.tasks[i].id;
                if (task == check.task) continue;
                for (int wrong = 0; wrong <= wrong_versions; ++wrong) {
                    starter.select(i, wrong);
                    if (run().outcome == check::Outcome::passed) continue;
                    (wrong == 0 ? needs : leans_on)[check.name].insert(task);
                    break;
                }
            }
            starter.select_none(), starter.take_reached();
        }
    }
    const std::string manifest = "labs/" + GetParam().folder + "/lab.toml";
    for (const TaskInfo& task : manifest_.tasks) {
        if (is_shader(task.file)) continue;
        static const std::regex key("(^|\n)needs = [^\n]*");
        const grade::CourseFiles files = {
            {task.file, starter_of_task(read_file(course_root() / task.file), task.file, task.id)},
            {manifest, std::regex_replace(read_file(course_root() / manifest), key, "$1")}};
        const std::vector<VariantCheck> checks = check_variant(GetParam(), files, expected);
        EXPECT_EQ(checks.size(), blind.checks.size()) << task.id;
        for (const VariantCheck& check : checks)
            if (check.outcome != "passed") needs[check.name].insert(task.id);
    }
    for (const CheckInfo& check : manifest_.checks) {
        if (check.added) continue;
        // A check that compares with another check also depends on the other's tasks.
        std::set<std::string> all = needs[check.name], wrong = leans_on[check.name];
        for (const CheckInfo* last = &check; last->against != "truth" && last->against != "solution";) {
            last = &manifest_.check(last->against);
            all.insert(last->task), all.merge(std::set(needs[last->name])), wrong.merge(std::set(leans_on[last->name]));
        }
        all.erase(check.task);
        EXPECT_EQ(check.needs, std::vector(all.begin(), all.end())) << check.name;
        for (const std::string& task : check.leans_on)
            if (!wrong.contains(task) && is_failed_by_mistake(GetParam(), blind, task, check, expected.at(check.name)))
                wrong.insert(task);
        std::erase_if(wrong, [&](const std::string& task) { return task == check.task || all.contains(task); });
        EXPECT_EQ(check.leans_on, std::vector(wrong.begin(), wrong.end())) << "leans_on of " << check.name;
    }
}

INSTANTIATE_TEST_SUITE_P(Labs, Course, testing::ValuesIn(registry()),
                         [](const auto& lab) { return "Lab" + lab.param.folder; });

}  // namespace
}  // namespace relief
