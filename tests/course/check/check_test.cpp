// The next step for a student whose tasks depend on each other.
#include "framework/course/check/check.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <limits>
#include <map>
#include <set>

#include "framework/core/base/paths.h"
#include "framework/course/check/hidden_checks.h"
#include "framework/course/check/last_points.h"
#include "tests/support.h"

namespace relief::check {
namespace {

const Verdict right{Outcome::passed, {}}, wrong{Outcome::wrong, "off by 3"}, open{Outcome::unfinished, {}};

CheckInfo check(const char* task, std::vector<std::string> needs) {
    CheckInfo info;
    info.task = task, info.look_at = std::string("own hint of ") + task, info.needs = std::move(needs);
    return info;
}

/// The checks of 1.3 depend on 1.1 and 1.2. 1.1 and 1.2 depend on each other, and each also has a check of its own.
Manifest manifest() {
    Manifest manifest;
    manifest.checks = {check("1.1", {}), check("1.1", {"1.2"}), check("1.2", {}), check("1.2", {"1.1"}),
                       check("1.3", {"1.1", "1.2"})};
    for (const char* id : {"1.1", "1.2", "1.3"}) manifest.tasks.push_back({.id = id, .title = {}, .file = {}});
    return manifest;
}

std::vector<TaskIds> first(const std::vector<Verdict>& said, const std::set<std::string>& recognised = {},
                           const Manifest& all = manifest()) {
    std::vector<TaskIds> first;
    for (const Cause& cause : causes_of(all, said, [&](const std::string& task) { return recognised.contains(task); }))
        first.push_back(cause.first);
    return first;
}

/// Returns the hints of all checks, in the manifest's order.
std::vector<std::string> hints_of(const Manifest& manifest, const std::vector<Verdict>& said) {
    std::vector<std::string> hints(said.size());
    for (const TaskVerdict& task : judge_lab(manifest, said))
        for (const Verdict& check : task.checks) hints[check.index] = check.look_at;
    return hints;
}

/// Judges two public examples of task 1.1, of which the second one has two calls, by the values of the three calls.
Verdict judge_calls(std::vector<float> values) {
    Manifest all = manifest();
    all.examples = {{.task = "1.2", .asks = "of another task", .calls = {"f()"}},
                    {.task = "1.1", .asks = "hidden", .calls = {"f(9)"}, .hidden = true},
                    {.task = "1.1", .asks = "of unit length", .calls = {"f(1)"}},
                    {.task = "1.1", .asks = "never NaN", .calls = {"f(0)", "f(2)"}}};
    CheckInfo info = check("1.1", {});
    info.shot.probe.name = calls_probe, info.shot.calls.texts = {"f(1)", "f(0)", "f(2)"};
    Image expected(3, 1, 4), drawn(3, 1, 4);
    expected.values = {1, 0, 0, 0, 0, 0, 0, 0, 1e30f, 0, 0, 0};
    drawn.values = std::move(values);
    return judge(all, info, drawn, expected);
}

TEST(Examples, QuoteTheWordsWhoseCallsFail) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(judge_calls({1.00005f, 0, 0, 0, 0, 0, 0, 0, 1e30f, 0, 0, 0}).outcome, Outcome::passed)
        << "within 1e-4, relative where values are large";
    const Verdict too_long = judge_calls({1.0002f, 0, 0, 0, 0, 0, 0, 0, 1e30f, 0, 0, 0});
    EXPECT_EQ(too_long.outcome, Outcome::wrong);
    EXPECT_EQ(too_long.look_at, "a call for these words of the task fails: \"of unit length\"");
    EXPECT_EQ(too_long.found, "1 of 3 calls return something else: f(1) is 1.0002, not 1");
    EXPECT_EQ(judge_calls({1, 0, 0, 0, nan, 0, 0, 0, 1e30f, 0, 0, 0}).look_at,
              "a call for these words of the task fails: \"never NaN\"");
    EXPECT_EQ(judge_calls({1, 0, 0, 0, no_surface, no_surface, no_surface, no_surface, 1e30f, 0, 0, 0}).outcome,
              Outcome::wrong);
    EXPECT_EQ(judge_calls({1, 0, 0, 9, 0, 0, 0, 0, 1, 0, 0, 0}).look_at,
              "calls for these words of the task fail: \"of unit length\"; \"never NaN\"")
        << "all four components count";
}

TEST(AnEndlessLoop, IsNamedByTheRoundsAfterWhichTheRendererLeavesIt) {
    const std::string sentence = "a loop does not end";
    EXPECT_TRUE(judge_calls({65536, 0, 0, 0, 0, 0, 0, 0, 1e30f, 0, 0, 0}).look_at.starts_with(sentence));
    EXPECT_FALSE(judge_calls({65538, 0, 0, 0, 0, 0, 0, 0, 1e30f, 0, 0, 0}).look_at.starts_with(sentence));
    Manifest all = manifest();
    ProbeInfo steps;
    steps.name = "steps";
    all.probes.push_back(steps);
    CheckInfo info = check("1.1", {});
    info.shot.probe.name = "steps", info.limits.mean = 1;
    Image expected(2, 1, 4), drawn(2, 1, 4);
    expected.values = {12, 0, 0, 0, 65536, 0, 0, 0};
    drawn.values = expected.values;
    EXPECT_EQ(judge(all, info, drawn, expected).outcome, Outcome::passed) << "a value that is expected";
    drawn.values[0] = 65535;
    EXPECT_TRUE(judge(all, info, drawn, expected).look_at.starts_with(sentence));
}

TEST(WaitsText, JoinsTheNamesOfTasks) {
    EXPECT_EQ(waits_text({"1.3"}, "written"), "waits for task 1.3, which is not written yet");
    EXPECT_EQ(waits_text({"1.2", "1.4"}, "right"), "waits for tasks 1.2 and 1.4, which are not right yet");
    EXPECT_EQ(waits_text({"1.2", "1.3", "1.4"}, "written"),
              "waits for tasks 1.2, 1.3 and 1.4, which are not written yet");
}

TEST(JudgeText, SaysWhyACheckCannotBeDrawn) {
    Manifest all = manifest();
    for (TaskInfo& task : all.tasks) task.file = "shaders/01_a/" + task.id + ".glsl";
    std::map<std::string, std::string> files, refusals;
    const TaskTexts texts = {.read = [&](const std::string& file) -> std::optional<std::string> {
                                 const auto found = files.find(file);
                                 return found == files.end() ? std::nullopt : std::optional(found->second);
                             },
                             .refused = [&](const std::string& file) { return refusals[file]; }};
    const auto judged = [&](size_t check) {
        const auto said = judge_text(all, all.checks[check], texts, OtherShaders());
        return said ? std::pair(said->outcome, said->found) : std::pair(Outcome::passed, std::string());
    };
    EXPECT_EQ(judged(0), std::pair(Outcome::unfinished, std::string("there is no shaders/01_a/1.1.glsl")));
    files["shaders/01_a/1.1.glsl"] = "// TASK 1.1\nfloat f() { return unfinished(0.0); }\n";
    EXPECT_EQ(judged(0), std::pair(Outcome::unfinished, std::string("not written yet")));
    files["shaders/01_a/1.1.glsl"] = "// TASK 1.1\nfloat f() { return 1.0; }\n";
    EXPECT_EQ(judged(0).first, Outcome::passed);
    EXPECT_EQ(judged(1), std::pair(Outcome::waiting, std::string("waits for task 1.2, which is not written yet")));
    all.tasks[0].functions = {"f()", "g(float)"};
    EXPECT_EQ(judged(0).first, Outcome::broken);
    EXPECT_EQ(
        judged(0).second,
        "shaders/01_a/1.1.glsl has no function `g(float)`, which task 1.1 asks for: keep the names and signatures");
    EXPECT_EQ(culprit_of(all, "shaders/01_a/task.frag:7: 'g' : no matching function", texts), "1.1")
        << "another file calls it";
    all.tasks[0].functions = {"f()"};
    EXPECT_EQ(culprit_of(all, "shaders/01_a/task.frag:7: 'g' : no matching function", texts), "");
    EXPECT_EQ(culprit_of(all, "shaders/01_a/1.1.glsl:2: syntax error", texts), "1.1");
    refusals["shaders/01_a/1.1.glsl"] = "larger than 1 MiB";
    EXPECT_EQ(judged(0), std::pair(Outcome::broken, std::string("shaders/01_a/1.1.glsl is larger than 1 MiB")));
}

TEST(Points, HaveAtMostTwoDecimals) {
    EXPECT_EQ(points_text(4.0 / 3), "1.33");
    EXPECT_EQ(points_text(20.6), "20.6");
    EXPECT_EQ(points_text(10), "10");
    EXPECT_EQ(points_text(0), "0");
}

TEST(PointsText, GivesTheRangeThatChecksLeaveOpenWhileTheyWait) {
    TaskVerdict task{.id = "1.2", .title = {}, .file = {}, .of = 3, .checks = {right, wrong}};
    EXPECT_EQ(points_text(task), "1.5 of 3 points");
    task.checks[1].outcome = Outcome::waiting, task.checks[1].waits_for = {"1.1"};
    EXPECT_EQ(points_text(task), "1.5 to 3 of 3 points: 1.5 wait for 1.1");
    task.checks[0].outcome = Outcome::waiting, task.checks[0].waits_for = {"1.1", "1.3"};
    EXPECT_EQ(points_text(task), "0 to 3 of 3 points: 3 wait for 1.1 and 1.3");
    EXPECT_EQ(points_text({task, {.id = "1.3", .title = {}, .file = {}, .of = 2, .checks = {right, wrong}}}),
              "1 to 4 of 5 points");
}

TEST(WaitingChecks, AreGroupedByTheirReasonWhereverTheyStand) {
    const auto waits = [](const char* found) { return Verdict{.outcome = Outcome::waiting, .found = found}; };
    const Verdict a = waits("waits for task 1.1, which is not written yet"),
                  b = waits("waits for task 1.2, which is not right yet"),
                  unseen{.outcome = Outcome::broken, .found = "1.glsl:2: error", .details = "the line"};
    const TaskVerdict task{
        .id = "1.3", .title = {}, .file = {}, .of = 3, .checks = {a, right, b, unseen, a, wrong, unseen, b}};
    const std::vector<WaitingChecks> groups = waiting_checks(task);
    ASSERT_EQ(groups.size(), 3u);
    EXPECT_EQ(groups[0].checks, (std::vector<size_t>{0, 4}));
    EXPECT_EQ(groups[1].checks, (std::vector<size_t>{2, 7}));
    EXPECT_EQ(groups[2].checks, (std::vector<size_t>{3, 6}));
    EXPECT_EQ(groups[0].reason, reason_to_wait(a));
    const Verdict* const results[] = {nullptr, &b, nullptr};
    ASSERT_EQ(waiting_checks(results).size(), 1u);
    EXPECT_EQ(waiting_checks(results)[0].checks, std::vector<size_t>{1});
}

TEST(LastPoints, AreGoneOnceATaskIsSavedAfterItsChecksHaveStarted) {
    const TemporaryFolder course;
    std::filesystem::create_directories(course.path() / "labs");
    const std::filesystem::path file = course.write("shaders/01_a/task.glsl", "");
    const CourseElsewhere elsewhere(course.path());
    LabEntry lab{};
    lab.folder = "01_a";
    Manifest manifest;
    manifest.tasks.push_back({.id = "1.1", .title = {}, .file = "shaders/01_a/task.glsl"});
    const std::vector<TaskVerdict> tasks = {{.id = "1.1", .title = {}, .file = {}, .of = 3, .checks = {right, wrong}}};
    EXPECT_EQ(last_points(lab, manifest), std::nullopt) << "no checks have run";
    const auto now = std::filesystem::last_write_time(file);
    // Saved an hour ago, checked, and saved while the checks ran: before their points were kept.
    std::filesystem::last_write_time(file, now - std::chrono::hours(1));
    const auto saved = last_saved(manifest);
    keep_points(lab, tasks, saved);
    EXPECT_EQ(last_points(lab, manifest), "1.5");
    std::filesystem::last_write_time(file, now - std::chrono::minutes(1));
    keep_points(lab, tasks, saved);
    EXPECT_EQ(last_points(lab, manifest), std::nullopt);
    keep_points(lab, tasks, last_saved(manifest));
    EXPECT_EQ(last_points(lab, manifest), "1.5");
    std::filesystem::remove(file);
    EXPECT_EQ(last_points(lab, manifest), std::nullopt);
}

TEST(PointsText, CountsOptionalTasksApart) {
    const TaskVerdict task{.id = "1.2", .title = {}, .file = {}, .of = 3, .checks = {right, wrong}};
    TaskVerdict more{.id = "1.3", .title = {}, .file = {}, .of = 2, .optional = true, .checks = {right, wrong}};
    EXPECT_EQ(points_text(more), "1 of 2 optional points");
    EXPECT_EQ(points_text({task, more}), "1.5 of 3 points, and 1 of 2 optional points");
    more.hidden_checks = 1;
    EXPECT_EQ(points_text({task, more}),
              "1.5 of 3 public points, and 1 of 2 optional points; 1 more check decides the rest when it is graded");
}

TEST(PointsText, TellsStudentsOfHiddenChecks) {
    const TaskVerdict task{.id = "1.2", .title = {}, .file = {}, .of = 3, .checks = {right}, .hidden_checks = 1};
    EXPECT_EQ(points_text(std::vector{task}), "3 of 3 public points; 1 more check decides the rest when it is graded");
    EXPECT_EQ(points_text(std::vector{task, task}),
              "6 of 6 public points; 2 more checks decide the rest when it is graded");
}

TEST(HiddenCheck, IsCountedAndItsWordsAreToldIfNoPublicCallTestsThem) {
    Manifest all = manifest();
    EXPECT_TRUE(hidden_checks(all).empty());
    all.checks[0].hidden = all.checks[2].hidden = all.checks[3].hidden = true;
    all.examples = {{.task = "1.1", .asks = "of unit length", .calls = {"f(1)"}},
                    {.task = "1.1", .asks = "of unit length", .calls = {"f(2)"}, .hidden = true},
                    {.task = "1.1", .asks = "never NaN", .calls = {"f(0)"}, .hidden = true}};
    const HiddenByTask hidden = hidden_checks(all);
    EXPECT_EQ(hidden.size(), 2u);
    EXPECT_EQ(hidden.at("1.1").count, 1);
    EXPECT_EQ(hidden.at("1.1").not_tested, std::vector<std::string>{"never NaN"});
    EXPECT_EQ(hidden.at("1.2").count, 2);
}

TEST(PointsText, PublicAndHiddenCallsForTheTasksWordsAreOneShare) {
    Verdict words = right, more = wrong;
    words.of_words = more.of_words = more.hidden = true;
    TaskVerdict task{.id = "1.2", .title = {}, .file = {}, .of = 3, .checks = {right, right, words, more}};
    EXPECT_EQ(task.points(), 2);
    task.checks[2].outcome = Outcome::wrong;
    EXPECT_EQ(task.points(), 2) << "one demand is one loss";
    EXPECT_EQ(task.share_of(task.checks[0]).points, 1);
    EXPECT_EQ(task.share_of(task.checks[2]).of, 0.5);
    task.checks[2].outcome = Outcome::passed, task.checks[3].outcome = Outcome::waiting;
    EXPECT_EQ(task.points(), 2);
    EXPECT_EQ(task.waiting_points(), 1);
    task.checks[3].outcome = Outcome::passed;
    EXPECT_EQ(task.points(), 3);
    EXPECT_EQ(task.share_of(task.checks[3]).points, 0.5);
}

TEST(PutRightFirst, IsTheOneTaskThatExplainsAllFailures) {
    EXPECT_EQ(first({right, right, right, right, right}), std::vector<TaskIds>(5));
    EXPECT_EQ(first({right, right, right, right, wrong}), std::vector<TaskIds>(5)) << "1.3 itself";
    EXPECT_EQ(first({right, right, wrong, right, wrong}), (std::vector<TaskIds>{{}, {}, {}, {}, {"1.2"}}));
    EXPECT_EQ(first({right, wrong, wrong, wrong, wrong}), (std::vector<TaskIds>{{}, {"1.2"}, {}, {}, {"1.2"}}))
        << "'1.2' alone explains its own check";
    EXPECT_EQ(first({wrong, wrong, wrong, wrong, wrong}),
              (std::vector<TaskIds>{{}, {"1.2"}, {}, {"1.1"}, {"1.1", "1.2"}}))
        << "each has a failure of its own";
}

TEST(Together, AreTheTasksOfWhichNoCheckTellsTheWrongOne) {
    Manifest all = manifest();
    all.checks[0].needs = {"1.2"}, all.checks[2].needs = {"1.1"};  // no check sees 1.1 or 1.2 alone
    const std::vector<Verdict> said = {wrong, wrong, wrong, right, right};
    EXPECT_EQ(first(said, {}, all), std::vector<TaskIds>(5));
    const std::vector<Cause> causes = causes_of(all, said);
    for (const size_t i : {0u, 1u, 2u}) EXPECT_EQ(causes[i].together, (TaskIds{"1.1", "1.2"})) << i;
    EXPECT_EQ(hints_of(all, said)[2], "Task 1.1 or task 1.2 is wrong, or several of these: no check tells which")
        << "and no usual cause: it would blame one of them";
    EXPECT_EQ(first(said, {"1.2"}, all), (std::vector<TaskIds>{{"1.2"}, {"1.2"}, {}, {}, {}}))
        << "1.2 draws what a known mistake draws";
    all.checks[2].needs = {}, all.checks[3].leans_on = {};
    EXPECT_EQ(first({wrong, wrong, right, wrong, right}, {}, all), (std::vector<TaskIds>{{}, {}, {}, {"1.1"}, {}}))
        << "1.2 passes the check that sees it alone";
}

TEST(PutRightFirst, IsTheTaskOfACompilerError) {
    Verdict message{Outcome::broken, "shaders/01_a/task.glsl:7: syntax error"};
    EXPECT_EQ(first({message, message, message, message, message}), std::vector<TaskIds>(5))
        << "the message names the place itself";
    message.culprit = "1.2";
    EXPECT_EQ(first({message, message, message, message, message}),
              (std::vector<TaskIds>{{"1.2"}, {"1.2"}, {}, {}, {"1.2"}}));
}

TEST(PutRightFirst, IsTheNeededTaskIfBothDrawNonFiniteValues) {
    const Verdict nothing{Outcome::broken, "probe 'uv': 4 pixels are not finite"};
    EXPECT_EQ(first({right, right, nothing, right, nothing})[4], TaskIds{"1.2"});
}

TEST(PutRightFirst, NeverFormsACycle) {
    // In the second manifest no check is about one task alone.
    Manifest entangled = manifest();
    entangled.checks[0].leans_on = {"1.3"}, entangled.checks[2].leans_on = {"1.1"};
    for (const Manifest& all : {manifest(), entangled}) {
        for (unsigned set = 1; set < 32; ++set) {
            std::vector<Verdict> said;
            for (unsigned i = 0; i < 5; ++i) said.push_back(set >> i & 1 ? wrong : right);
            const std::vector<TaskIds> before = first(said, {}, all);
            // From each check, follows failed checks of the task that it waits for, up to one that waits for no task.
            std::set<size_t> ends;
            for (size_t round = 0; round < 5; ++round)
                for (size_t i = 0; i < 5; ++i) {
                    if (said[i].outcome == Outcome::passed) continue;
                    bool ends_there = before[i].empty();
                    for (size_t j = 0; j < 5; ++j)
                        for (const std::string& task : before[i])
                            ends_there |= all.checks[j].task == task && ends.contains(j);
                    if (ends_there) ends.insert(i);
                }
            for (size_t i = 0; i < 5; ++i)
                EXPECT_TRUE(said[i].outcome == Outcome::passed || ends.contains(i)) << i << " of " << set;
        }
    }
}

TEST(Hints, AreTheChecksOwnIfAllNeededTasksAreRight) {
    EXPECT_EQ(hints_of(manifest(), {right, right, right, right, wrong}),
              (std::vector<std::string>{"", "", "", "", "a usual cause lies here: own hint of 1.3"}));
    EXPECT_EQ(hints_of(manifest(), {right, open, right, {Outcome::machine, "x"}, {Outcome::broken, "x"}}),
              (std::vector<std::string>(5)))
        << "what does not draw says itself why";
}

TEST(Hints, NameTheNeededTaskHoweverTheCheckFailed) {
    EXPECT_EQ(hints_of(manifest(), {right, wrong, wrong, wrong, wrong}),
              (std::vector<std::string>{"", "put task 1.2 right first", "a usual cause lies here: own hint of 1.2", "",
                                        "put task 1.2 right first"}));
    for (const Outcome outcome : {Outcome::wrong, Outcome::crashed, Outcome::out_of_time, Outcome::out_of_memory})
        EXPECT_EQ(hints_of(manifest(), {right, right, wrong, right, {outcome, "off"}})[4], "put task 1.2 right first")
            << name_of(outcome);
}

// The later checks of a task name details. Code with another mistake has these right.
TEST(Hints, AreTheChecksOwnOnlyForTheFirstWrongCheckOfATask) {
    Verdict related = wrong, measured = wrong;
    related.relation = "yours is half of it", measured.look_at = "normalise it";
    EXPECT_EQ(
        hints_of(manifest(), {wrong, related, right, right, right}),
        (std::vector<std::string>{"a usual cause lies here: own hint of 1.1", "Yours is half of it", "", "", ""}));
    EXPECT_EQ(hints_of(manifest(), {right, related, right, right, right})[1],
              "a usual cause lies here: own hint of 1.1. Yours is half of it");
    EXPECT_EQ(hints_of(manifest(), {wrong, measured, right, right, right})[1], "normalise it");
    EXPECT_EQ(hints_of(manifest(), {right, wrong, wrong, right, right})[1], "put task 1.2 right first")
        << "a check that waits takes no hint from the others of its task";
    EXPECT_EQ(hints_of(manifest(), {wrong, wrong, wrong, right, right})[0], "a usual cause lies here: own hint of 1.1");
}

// A usual cause is a guess. The words of the failed call may refute it.
TEST(Hints, NameNoUsualCauseBesideAFailedCall) {
    Manifest all = manifest();
    all.checks[1].needs = {}, all.checks[1].shot.calls.texts = {"f(1)"};
    Verdict related = wrong, called = wrong;
    related.relation = "yours is half of it", called.look_at = "a call fails";
    EXPECT_EQ(hints_of(all, {related, called, right, right, right}),
              (std::vector<std::string>{"Yours is half of it", "a call fails", "", "", ""}))
        << "also before the call, in the order of the checks";
    EXPECT_EQ(hints_of(all, {wrong, right, right, right, right})[0], "a usual cause lies here: own hint of 1.1")
        << "all calls are right";
    EXPECT_EQ(hints_of(all, {right, called, wrong, right, right})[2], "a usual cause lies here: own hint of 1.2")
        << "the call is of another task";
}

TEST(Hints, ReportThatOnlyTheLengthIsWrong) {
    Manifest manifest;
    ProbeInfo& probe = manifest.probes.emplace_back();
    probe.name = "normal", probe.error = ErrorMetric::angle, probe.unit = "degree";
    CheckInfo& info = manifest.checks.emplace_back(check("1.1", {}));
    info.against = "truth", info.limits.mean = 1, info.shot.probe.name = "normal", info.shot.size = {1, 1};
    manifest.tasks.push_back({.id = "1.1", .title = {}, .file = {}});
    const auto hint = [&](float x, float y, float z) {
        Image drawn(1, 1, 4), expected(1, 1, 4);
        drawn.values = {x, y, z, 1}, expected.values = {0, 0, 1, 1};
        return hints_of(manifest, {judge(manifest, info, drawn, expected)}).front();
    };
    EXPECT_EQ(hint(0, 0, 2),
              "the directions are right, but their length is not 1: normalise the vector that you return");
    EXPECT_EQ(hint(0, 2, 0), "a usual cause lies here: own hint of 1.1") << "the direction is wrong, too";
    EXPECT_EQ(hint(0, 0, 1), "");
}

TEST(Hints, NameATaskThatACheckLeansOn) {
    Manifest all = manifest();
    all.checks[4].needs = {"1.1"}, all.checks[4].leans_on = {"1.2"};
    EXPECT_EQ(hints_of(all, {right, right, wrong, right, wrong})[4], "put task 1.2 right first");
}

// A student's C++ could show a solution in a drawing among solutions.
TEST(AmongSolutions, OnlyTheOutcomeOfACheckReachesItsVerdict) {
    std::vector<Verdict> checks = {wrong, wrong, right, wrong, {Outcome::broken, "it throws"}};
    checks[4].details = "a line", checks[4].culprit = "1.1";
    std::vector<bool> compared;
    Evidence evidence;
    evidence.among_solutions = [](const std::map<std::string, std::vector<size_t>>& lost) {
        EXPECT_EQ(lost, (std::map<std::string, std::vector<size_t>>{{"1.1", {0, 1}}, {"1.2", {3}}, {"1.3", {4}}}));
        return std::map<size_t, Outcome>{
            {0, Outcome::wrong}, {1, Outcome::wrong}, {3, Outcome::passed}, {4, Outcome::wrong}};
    };
    evidence.recognise = [&](const std::string& task, const std::vector<Verdict>&, const std::vector<bool>& are) {
        if (task == "1.1") compared = are;
        return std::optional<NamedMistake>();
    };
    std::vector<TaskVerdict> tasks = judge_lab(manifest(), checks, evidence);
    EXPECT_EQ(tasks[0].checks[0].found, "off by 3");
    EXPECT_EQ(tasks[0].checks[1].found, "off by 3") << "1.2 is right, so this is the mistake of 1.1 alone";
    EXPECT_EQ(tasks[1].checks[1].found, "passed with the solution of the other tasks");
    const Verdict& thrown = tasks[2].checks[0];
    EXPECT_EQ(thrown.outcome, Outcome::wrong);
    EXPECT_EQ(thrown.found, "wrong with the solution of the other tasks, too");
    EXPECT_EQ(thrown.details + thrown.culprit, "");
    EXPECT_EQ(compared, (std::vector<bool>{true, true, true, false, false}))
        << "a picture that shows the mistake of another task names none";

    checks[4] = wrong, checks[4].look_at = "flip y", checks[4].relation = "it is the half";
    tasks = judge_lab(manifest(), checks, evidence);
    EXPECT_EQ(tasks[2].checks[0].found, "off by 3; wrong with the solution of the other tasks, too");
    EXPECT_EQ(tasks[2].checks[0].look_at, "a usual cause lies here: own hint of 1.3");
}

}  // namespace
}  // namespace relief::check
