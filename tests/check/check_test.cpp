// What a student is told to do next, when tasks lean on each other.
#include "framework/check/check.h"

#include <gtest/gtest.h>

#include <set>

namespace relief {
namespace {

const Judgement right{Outcome::passed, {}}, wrong{Outcome::wrong, "off by 3"}, open{Outcome::unfinished, {}};

CheckInfo check(const char* task, std::vector<std::string> needs) {
    CheckInfo info;
    info.task = task, info.look_at = std::string("own hint of ") + task, info.needs = std::move(needs);
    return info;
}

/// 1.3 is seen through 1.1 and 1.2; 1.1 and 1.2 lean on each other, and each has a check of its own.
Manifest manifest() {
    Manifest manifest;
    manifest.checks = {check("1.1", {}), check("1.1", {"1.2"}), check("1.2", {}), check("1.2", {"1.1"}),
                       check("1.3", {"1.1", "1.2"})};
    return manifest;
}

TEST(WaitsFor, NamesTheTasksThatAreNotWritten) {
    const CheckInfo info = check("1.1", {"1.2", "1.3", "1.4"});
    const auto all_but = [](std::set<std::string> open_tasks) {
        return [open_tasks](const std::string& task) { return !open_tasks.contains(task); };
    };
    EXPECT_EQ(waits_for(info, all_but({})), "");
    EXPECT_EQ(waits_for(info, all_but({"1.3"})), "waits for task 1.3, which is not written yet");
    EXPECT_EQ(waits_for(info, all_but({"1.2", "1.4"})), "waits for tasks 1.2 and 1.4, which are not written yet");
    EXPECT_EQ(waits_for(info, all_but({"1.2", "1.3", "1.4"})),
              "waits for tasks 1.2, 1.3 and 1.4, which are not written yet");
    EXPECT_EQ(waits_for(info, all_but({"1.5"})), "") << "not needed";
}

TEST(Hints, AreTheChecksOwnWhereNothingThatItNeedsIsWrong) {
    EXPECT_EQ(hints(manifest(), {right, right, right, right, wrong}),
              (std::vector<std::string>{"", "", "", "", "own hint of 1.3"}));
    EXPECT_EQ(hints(manifest(), {right, open, right, {Outcome::machine, "x"}, {Outcome::broken, "x"}}),
              (std::vector<std::string>(5)))
        << "what does not draw says itself why";
}

TEST(Hints, NameTheNeededTaskThatIsWrongByItself) {
    EXPECT_EQ(hints(manifest(), {right, wrong, wrong, wrong, wrong}),
              (std::vector<std::string>{"", "put task 1.2 right first", "own hint of 1.2", "own hint of 1.2",
                                        "put task 1.2 right first"}));
    const std::vector<std::string> crashed =
        hints(manifest(), {right, {Outcome::broken, "no number"}, {Outcome::crashed, "signal 11"}, right, right});
    EXPECT_EQ(crashed[1], "put task 1.2 right first");
}

TEST(Hints, NameWhatComesFirstHoweverACheckHasFailed) {
    for (const Outcome outcome : {Outcome::wrong, Outcome::crashed, Outcome::out_of_time, Outcome::out_of_memory}) {
        const std::vector<Judgement> said = {right, right, wrong, right, {outcome, "off"}};
        EXPECT_EQ(hints(manifest(), said)[4], "put task 1.2 right first") << name_of(outcome);
        const Manifest all = manifest();
        const std::vector<const CheckInfo*> first = put_right_first(all, said);
        EXPECT_EQ(first, (std::vector<const CheckInfo*>{nullptr, nullptr, nullptr, nullptr, &all.checks[2]}));
    }
}

TEST(Hints, NameWhatACheckLeansOnAndDoNotWaitForIt) {
    Manifest all = manifest();
    all.checks[4].needs = {"1.1"}, all.checks[4].leans_on = {"1.2"};
    EXPECT_EQ(hints(all, {right, right, wrong, right, wrong})[4], "put task 1.2 right first");
    EXPECT_EQ(hints(all, {right, wrong, right, right, wrong})[4], "put task 1.1 right first");
    EXPECT_EQ(waits_for(all.checks[4], [](const std::string& task) { return task != "1.2"; }), "");
}

TEST(Hints, SendNobodyInACircle) {
    // Each of the two is wrong only where the other takes part: nothing says which.
    EXPECT_EQ(hints(manifest(), {right, wrong, right, wrong, right}),
              (std::vector<std::string>{"", "own hint of 1.1", "", "own hint of 1.2", ""}));
    // Of any set of failed checks, one that is about the fewest tasks keeps its own hint, and so does whatever a hint
    // names.
    const Manifest all = manifest();
    for (unsigned set = 1; set < 32; ++set) {
        std::vector<Judgement> said;
        for (unsigned i = 0; i < 5; ++i) said.push_back(set >> i & 1 ? wrong : right);
        const std::vector<std::string> found = hints(all, said);
        for (size_t i = 0; i < 5; ++i) {
            if (said[i].outcome == Outcome::passed || found[i] == all.checks[i].look_at) continue;
            bool named_has_its_own = false;
            for (size_t j = 0; j < 5; ++j)
                named_has_its_own |=
                    found[i] == "put task " + all.checks[j].task + " right first" && found[j] == all.checks[j].look_at;
            EXPECT_TRUE(named_has_its_own) << found[i] << " in " << set;
        }
    }
}

TEST(Hints, LeaveACompilersMessageToSpeakForItself) {
    const Judgement message{Outcome::broken, "task.glsl:7: syntax error"};
    EXPECT_EQ(hints(manifest(), {message, message, message, message, message}), (std::vector<std::string>(5)));
}

}  // namespace
}  // namespace relief
