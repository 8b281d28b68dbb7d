// The next step for a student whose tasks depend on each other.
#include "framework/course/check/check.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

namespace relief::check {
namespace {

const Judgement right{Outcome::passed, {}}, wrong{Outcome::wrong, "off by 3"}, open{Outcome::unfinished, {}};

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

std::vector<TaskIds> first(const std::vector<Judgement>& said, const std::set<std::string>& recognised = {}) {
    return put_right_first(manifest(), said, recognised);
}
std::vector<std::string> hints_of(const Manifest& manifest, const std::vector<Judgement>& said) {
    return hints(manifest, said, put_right_first(manifest, said));
}

/// Judges two examples of task 1.1, of which the second one has two calls, by the values of the three calls.
Judgement judge_calls(std::vector<float> values) {
    Manifest all = manifest();
    all.examples = {{.task = "1.2", .asks = "of another task", .calls = {"f()"}, .edits = {}},
                    {.task = "1.1", .asks = "of unit length", .calls = {"f(1)"}, .edits = {}},
                    {.task = "1.1", .asks = "never NaN", .calls = {"f(0)", "f(2)"}, .edits = {}}};
    CheckInfo info = check("1.1", {});
    info.shot.probe.name = calls_probe, info.shot.calls.texts = {"f(1)", "f(0)", "f(2)"};
    Image expected(3, 1, 4), drawn(3, 1, 4);
    expected.values = {1, 0, 0, 0, 0, 0, 0, 0, 1e30f, 0, 0, 0};
    drawn.values = std::move(values);
    return judge(all, info, drawn, expected);
}

TEST(Examples, QuoteTheWordsThatDoNotHold) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(judge_calls({1.00005f, 0, 0, 0, 0, 0, 0, 0, 1e30f, 0, 0, 0}).outcome, Outcome::passed)
        << "within 1e-4, relative where values are large";
    const Judgement too_long = judge_calls({1.0002f, 0, 0, 0, 0, 0, 0, 0, 1e30f, 0, 0, 0});
    EXPECT_EQ(too_long.outcome, Outcome::wrong);
    EXPECT_EQ(too_long.look_at, "the task says: \"of unit length\"");
    EXPECT_EQ(too_long.found, "1 of 3 calls return something else");
    EXPECT_EQ(judge_calls({1, 0, 0, 0, nan, 0, 0, 0, 1e30f, 0, 0, 0}).look_at, "the task says: \"never NaN\"");
    EXPECT_EQ(judge_calls({1, 0, 0, 0, no_surface, no_surface, no_surface, no_surface, 1e30f, 0, 0, 0}).outcome,
              Outcome::wrong);
    EXPECT_EQ(judge_calls({1, 0, 0, 9, 0, 0, 0, 0, 1, 0, 0, 0}).look_at,
              "the task says: \"of unit length\"; \"never NaN\"")
        << "all four components count";
}

TEST(MissingTasks, AreTheUnwrittenTasksThatTheCheckNeeds) {
    const CheckInfo info = check("1.1", {"1.2", "1.3", "1.4"});
    const auto all_but = [](std::set<std::string> open_tasks) {
        return [open_tasks](const std::string& task) { return !open_tasks.contains(task); };
    };
    EXPECT_EQ(missing_tasks(info, all_but({})), TaskIds());
    EXPECT_EQ(missing_tasks(info, all_but({"1.2", "1.4"})), (TaskIds{"1.2", "1.4"}));
    EXPECT_EQ(missing_tasks(info, all_but({"1.5"})), TaskIds()) << "not needed";
    EXPECT_EQ(waits_text({"1.3"}, "written"), "waits for task 1.3, which is not written yet");
    EXPECT_EQ(waits_text({"1.2", "1.4"}, "right"), "waits for tasks 1.2 and 1.4, which are not right yet");
    EXPECT_EQ(waits_text({"1.2", "1.3", "1.4"}, "written"),
              "waits for tasks 1.2, 1.3 and 1.4, which are not written yet");
}

TEST(PointsText, ReportsThePointsThatWaitForOtherTasks) {
    const Manifest all = manifest();
    const TaskInfo task{.id = "1.2", .title = {}, .file = {}, .points = 3};
    TaskResult result{
        &task,
        {{.check = &all.checks[2], .outcome = Outcome::passed}, {.check = &all.checks[3], .outcome = Outcome::wrong}}};
    EXPECT_EQ(points_text(result), "1.5 of 3 points");
    result.checks[1].outcome = Outcome::waiting, result.checks[1].waits_for = {"1.1"};
    EXPECT_EQ(points_text(result), "1.5 of 3 points, 1.5 waiting for 1.1");
    result.checks[0].outcome = Outcome::waiting, result.checks[0].waits_for = {"1.1", "1.3"};
    EXPECT_EQ(points_text(result), "0 of 3 points, 3 waiting for 1.1 and 1.3");
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

TEST(PutRightFirst, PrefersTheTaskWithMoreFailedChecksIfTwoExplainAll) {
    Manifest all = manifest();
    all.checks[0].needs = {"1.2"};  // every check of 1.1 needs 1.2
    const std::vector<Judgement> said = {wrong, wrong, right, wrong, right};
    EXPECT_EQ(put_right_first(all, said), (std::vector<TaskIds>{{}, {}, {}, {"1.1"}, {}}));
    EXPECT_EQ(put_right_first(all, said, {"1.2"}), (std::vector<TaskIds>{{"1.2"}, {"1.2"}, {}, {}, {}}))
        << "1.2 draws what a known mistake draws";
}

TEST(PutRightFirst, IsTheTaskOfACompilerError) {
    Judgement message{Outcome::broken, "shaders/01_a/task.glsl:7: syntax error"};
    EXPECT_EQ(first({message, message, message, message, message}), std::vector<TaskIds>(5))
        << "the message names the place itself";
    message.culprit = "1.2";
    EXPECT_EQ(first({message, message, message, message, message}),
              (std::vector<TaskIds>{{"1.2"}, {"1.2"}, {}, {}, {"1.2"}}));
}

TEST(PutRightFirst, IsTheNeededTaskIfBothDrawNonFiniteValues) {
    const Judgement nothing{Outcome::broken, "probe 'uv': 4 pixels are not finite"};
    EXPECT_EQ(first({right, right, nothing, right, nothing})[4], TaskIds{"1.2"});
}

TEST(PutRightFirst, NeverFormsACycle) {
    // In the second manifest no check is about one task alone.
    Manifest entangled = manifest();
    entangled.checks[0].leans_on = {"1.3"}, entangled.checks[2].leans_on = {"1.1"};
    for (const Manifest& all : {manifest(), entangled}) {
        for (unsigned set = 1; set < 32; ++set) {
            std::vector<Judgement> said;
            for (unsigned i = 0; i < 5; ++i) said.push_back(set >> i & 1 ? wrong : right);
            const std::vector<TaskIds> before = put_right_first(all, said);
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
              (std::vector<std::string>{"", "", "", "", "own hint of 1.3"}));
    EXPECT_EQ(hints_of(manifest(), {right, open, right, {Outcome::machine, "x"}, {Outcome::broken, "x"}}),
              (std::vector<std::string>(5)))
        << "what does not draw says itself why";
}

TEST(Hints, NameTheNeededTaskHoweverTheCheckFailed) {
    EXPECT_EQ(
        hints_of(manifest(), {right, wrong, wrong, wrong, wrong}),
        (std::vector<std::string>{"", "put task 1.2 right first", "own hint of 1.2", "", "put task 1.2 right first"}));
    for (const Outcome outcome : {Outcome::wrong, Outcome::crashed, Outcome::out_of_time, Outcome::out_of_memory})
        EXPECT_EQ(hints_of(manifest(), {right, right, wrong, right, {outcome, "off"}})[4], "put task 1.2 right first")
            << name_of(outcome);
}

// The later checks of a task name details. Code with another mistake has these right.
TEST(Hints, AreTheChecksOwnOnlyForTheFirstWrongCheckOfATask) {
    Judgement related = wrong, measured = wrong;
    related.relation = "yours is half of it", measured.look_at = "normalise it";
    EXPECT_EQ(hints_of(manifest(), {wrong, related, right, right, right}),
              (std::vector<std::string>{"own hint of 1.1", "Yours is half of it", "", "", ""}));
    EXPECT_EQ(hints_of(manifest(), {right, related, right, right, right})[1], "own hint of 1.1. Yours is half of it");
    EXPECT_EQ(hints_of(manifest(), {wrong, measured, right, right, right})[1], "normalise it");
    EXPECT_EQ(hints_of(manifest(), {right, wrong, wrong, right, right})[1], "put task 1.2 right first")
        << "a check that waits takes no hint from the others of its task";
    EXPECT_EQ(hints_of(manifest(), {wrong, wrong, wrong, right, right})[0], "own hint of 1.1");
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
    EXPECT_EQ(hint(0, 2, 0), "own hint of 1.1") << "the direction is wrong, too";
    EXPECT_EQ(hint(0, 0, 1), "");
}

TEST(Hints, NameATaskThatACheckLeansOn) {
    Manifest all = manifest();
    all.checks[4].needs = {"1.1"}, all.checks[4].leans_on = {"1.2"};
    EXPECT_EQ(hints_of(all, {right, right, wrong, right, wrong})[4], "put task 1.2 right first");
    EXPECT_EQ(missing_tasks(all.checks[4], [](const std::string& task) { return task != "1.2"; }), TaskIds());
}

}  // namespace
}  // namespace relief::check
