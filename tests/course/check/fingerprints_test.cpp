// Fingerprints of known mistakes: how they are read and written, and which mistake they name.
#include "framework/course/check/fingerprints.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support.h"

namespace relief::check {
namespace {

const Verdict right{Outcome::passed, {}}, wrong{Outcome::wrong, "off by 3"};

/// Two tasks: 1.1 has two checks, and 1.2 needs 1.1.
Manifest manifest() {
    Manifest manifest;
    manifest.tasks = {{.id = "1.1", .title = {}, .file = {}}, {.id = "1.2", .title = {}, .file = {}}};
    for (const char* name : {"near", "far", "both"}) {
        CheckInfo& check = manifest.checks.emplace_back();
        check.task = manifest.checks.size() < 3 ? "1.1" : "1.2";
        check.name = name;
        check.shot.size = {2, 2};
        check.shot.probe.name = "height";
        if (check.task == "1.2") check.needs = {"1.1"};
    }
    return manifest;
}

const std::string text = R"({
    "checks": [{"name": "near", "at": [0, 5, 9], "solution": [1, 2, 3]},
               {"name": "far", "at": [0, 1], "solution": [4, "inf"]},
               {"name": "both", "at": [15], "solution": [7]}],
    "mistakes": [{"task": "1.1", "hint": "a \"sign\"", "draws": [[-1, -2, -3], null]},
                 {"task": "1.1", "hint": "halves", "draws": [[0.5, null, 1.5], [2, "nan"]]},
                 {"task": "1.2", "hint": "none", "draws": ["it throws"]}]})";

Fingerprints fingerprints() { return parse_fingerprints(text, "f.json", manifest()); }

Sample drawn(std::vector<float> values) { return {.values = std::move(values), .error = {}, .is_drawn = true}; }

std::string named(const std::vector<Verdict>& said, const Samples& samples, const std::string& task = "1.1",
                  const Exactness& exactness = {}) {
    const Fingerprints known = fingerprints();
    const auto names = name_mistakes(known, manifest(), said, samples, exactness);
    return names.contains(task) ? names.at(task).mistake->hint : "";
}

constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();

TEST(Fingerprints, NameTheMistakeThatMatchesAllFailedChecks) {
    EXPECT_EQ(named({wrong, right, right}, {{0, drawn({-1, -2, -3})}, {1, drawn({4, inf})}}), "a \"sign\"");
    EXPECT_EQ(named({wrong, wrong, right}, {{0, drawn({0.5f, 2, 1.5f})}, {1, drawn({2, nan})}}), "halves");
    EXPECT_EQ(named({wrong, wrong, right}, {{0, drawn({-1, -2, -3})}, {1, drawn({3, inf})}}), "")
        << "'far' fails, and not as it does with a wrong sign";
    EXPECT_EQ(named({wrong, right, right}, {{0, drawn({-1, -2, 3})}, {1, drawn({4, inf})}}), "") << "two of three";
    EXPECT_EQ(named({right, right, right}, {{0, drawn({-1, -2, -3})}, {1, drawn({4, inf})}}), "") << "nothing failed";
    EXPECT_EQ(named({wrong, right, right}, {{1, drawn({4, inf})}}), "") << "what failed was not drawn";
    EXPECT_EQ(named({right, right, {Outcome::broken, "it throws"}}, {{2, {.error = "it throws"}}}, "1.2"), "none");
    EXPECT_EQ(named({right, right, {Outcome::broken, "no number"}}, {{2, {.error = "no number"}}}, "1.2"), "");
}

TEST(Fingerprints, AnotherRendererMayBeOffByATenthOfTheMistake) {
    const auto off_by = [](float error, const Exactness& exactness) {
        return named({wrong, right, right}, {{0, drawn({-1 + error, -2, -3 - error})}, {1, drawn({4.1f, inf})}}, "1.1",
                     exactness);
    };
    EXPECT_EQ(off_by(0.3f, {}), "");
    EXPECT_EQ(off_by(0.3f, other_renderer), "a \"sign\"") << "the mean error is 4, and 'far' passes with the mistake";
    EXPECT_EQ(off_by(0.5f, other_renderer), "");
    EXPECT_EQ(named({wrong, right, right}, {{0, drawn({0.5f, 2, 1.5f})}, {1, drawn({4, inf})}}, "1.1", other_renderer),
              "")
        << "with the mistake 'far' fails";
}

// The picture is within the limits, and has the mistake's values.
TEST(Fingerprints, NameAMistakeThatFailsOnlyTheCallsForTheWordsOfItsTask) {
    Manifest with_calls = manifest();
    CheckInfo& words = with_calls.checks.emplace_back();
    words.task = "1.1", words.name = "the words", words.shot.calls.texts = {"f(1)"};
    const Fingerprints known = fingerprints();
    const auto names = [&](const Verdict& of_words, const Sample& near) {
        return name_mistakes(known, with_calls, {right, right, right, of_words}, {{0, near}, {1, drawn({4, inf})}});
    };
    const auto found = names(wrong, drawn({-1, -2, -3}));
    ASSERT_TRUE(found.contains("1.1"));
    EXPECT_EQ(found.at("1.1").mistake->hint, "a \"sign\"");
    EXPECT_TRUE(names(wrong, drawn({1, 2, 3})).empty()) << "the picture is the solution's";
    EXPECT_TRUE(names(right, drawn({-1, -2, -3})).empty()) << "nothing failed";
}

// Of another driver, or of another compiler of C++.
TEST(Agreement, ForgivesRoundingWhereTheMistakeOnlyRounds) {
    const Sample solution = drawn({0.5f, 1, 2}), rounds = drawn({0.500004f, 1.000002f, 1.999998f});
    EXPECT_EQ(agreement(drawn({0.499996f, 1.000001f, 2}), rounds, solution, true).differ, 0u);
    EXPECT_EQ(agreement(drawn({0.4999f, 1, 2}), rounds, solution, true).differ, 1u);
    const Sample wrong_by_little = drawn({0.501f, 1.001f, 2.001f});
    EXPECT_EQ(agreement(wrong_by_little, wrong_by_little, solution, true).share(), 1);
    EXPECT_EQ(agreement(solution, wrong_by_little, solution, true).share(), 0);
}

// An unlisted mistake may fail one check in the same way as a listed mistake.
TEST(Fingerprints, NameNoMistakeThatAPassedCheckContradicts) {
    const Sample half = drawn({0.5f, 2, 1.5f});
    EXPECT_EQ(named({wrong, wrong, right}, {{0, half}, {1, drawn({2, nan})}}), "halves");
    EXPECT_EQ(named({wrong, right, right}, {{0, half}, {1, drawn({4, inf})}}), "") << "'far' is right";
}

TEST(Fingerprints, NameAMistakeOfASingleFailedCheckAsAPossibility) {
    EXPECT_EQ(told("mind the sign", true, 2), "mind the sign");
    EXPECT_EQ(told("mind the sign", true, 1), "Perhaps: mind the sign");
    EXPECT_EQ(told("mind the sign", false, 2), "Perhaps: mind the sign");
    EXPECT_EQ(told("mind the sign. Or: mind the axis", true, 2), "Perhaps: mind the sign. Or: mind the axis")
        << "both draw the same";
}

TEST(Agreement, OfYesAndNoOrThreeValuesIsUncertain) {
    const Sample solution = drawn(std::vector<float>(24, 0));
    const auto is_certain = [&](size_t kinds) {
        Sample mistake = solution;
        for (size_t i = 0; i < mistake.values.size(); ++i) mistake.values[i] = float(1 + i % kinds);
        return agreement(mistake, mistake, solution, true).is_certain();
    };
    EXPECT_FALSE(is_certain(1));
    EXPECT_FALSE(is_certain(3));
    EXPECT_TRUE(is_certain(4));
    Agreement sum;
    for (const float value : {1.0f, 2.0f, 2.0f, 3.0f, 4.0f}) {
        EXPECT_FALSE(sum.is_certain());
        sum.add({.differ = 1, .agree = 1, .kinds = {value}});
    }
    EXPECT_TRUE(sum.is_certain());
}

TEST(Agreement, AllowsOneValueOf24ThatAnotherDriverDraws) {
    EXPECT_TRUE(is_like({.differ = 24, .agree = 23}, false));
    EXPECT_FALSE(is_like({.differ = 24, .agree = 22}, false));
    EXPECT_TRUE(is_like({.differ = 24, .agree = 17}, false, other_renderer));
    EXPECT_FALSE(is_like({.differ = 24, .agree = 16}, false, other_renderer));
    EXPECT_FALSE(is_like({.differ = 3, .agree = 2}, true));
    EXPECT_TRUE(is_like({.differ = 0, .agree = 0}, true)) << "it passes, with the mistake, too";
    EXPECT_FALSE(is_like({.differ = 0, .agree = 0}, false)) << "it fails where the mistake does not show";
}

TEST(Fingerprints, NameNoMistakeIfAllFailedChecksWaitForAnotherTask) {
    const std::vector<Verdict> said = {wrong, right, {Outcome::broken, "it throws"}};
    const Samples throws = {{0, drawn({9, 9, 9})}, {2, {.error = "it throws"}}};
    EXPECT_EQ(named(said, throws, "1.2"), "none");
    EXPECT_EQ(causes_of(manifest(), said)[2].first, TaskIds{"1.1"});
    EXPECT_EQ(named(said, {{0, throws.at(0)}}, "1.2"), "");
}

TEST(Fingerprints, SurviveARoundTripThroughText) {
    const Fingerprints before = fingerprints();
    const Fingerprints after = parse_fingerprints(text_of(before, manifest()), "f.json", manifest());
    ASSERT_EQ(after.mistakes.size(), 3u);
    for (size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(after.mistakes[i].hint, before.mistakes[i].hint);
        for (const auto& [check, sample] : before.mistakes[i].draws) {
            const Sample& read = after.mistakes[i].draws.at(check);
            EXPECT_EQ(read.error, sample.error);
            ASSERT_EQ(read.values.size(), sample.values.size());
            for (size_t j = 0; j < read.values.size(); ++j)
                EXPECT_TRUE(is_near(read.values[j], sample.values[j], 0)) << read.values[j];
        }
    }
    EXPECT_TRUE(std::isnan(after.mistakes[1].draws.at(1).values[1]));
    EXPECT_EQ(after.checks.at(0).values, (std::vector<size_t>{0, 5, 9}));
}

TEST(Fingerprints, ThatAreDamagedOrDoNotFitTheManifestAreRefused) {
    const auto refused = [](const std::string& find, const std::string& replace) {
        std::string changed = text;
        changed.replace(changed.find(find), find.size(), replace);
        return message_of([&] { parse_fingerprints(changed, "f.json", manifest()); });
    };
    EXPECT_TRUE(contains(refused("\"near\"", "\"neat\""), "f.json: lab.toml has no check 'neat'"));
    EXPECT_TRUE(contains(refused("0, 5, 9", "0, 5, 16"), "'at' must be whole numbers below 16 for 'near'"));
    EXPECT_TRUE(contains(refused("0, 5, 9", "0, -5, 9"), "'at' must be whole numbers below 16"));
    EXPECT_TRUE(contains(refused("[1, 2, 3]", "[1, 2]"), "'solution' must be 3 numbers for 'near'"));
    for (const char* draws : {"[-1, -2]", "[-1, -2, -3, -4]", "7"})
        EXPECT_TRUE(contains(refused("[-1, -2, -3]", draws), "'draws' must have 3 numbers for 'near'")) << draws;
    for (const char* damaged : {"[-1, \"x\", -3]", "[-1, [], -3]", "[-1,", "], [null"})
        EXPECT_TRUE(contains(refused("[-1, -2, -3]", damaged), "f.json: ")) << damaged;
}

}  // namespace
}  // namespace relief::check
