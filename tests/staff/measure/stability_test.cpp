// Sweeps of relief bench: the verdict on a curve, its output, and the promises of methods that need no context.
#include "framework/staff/measure/stability.h"

#include <gtest/gtest.h>

#include <cmath>

#include "framework/staff/measure/run.h"
#include "tests/staff/measure/sweeps.h"
#include "tests/support.h"

namespace relief::measure {
namespace {

BenchSweep sweep_of(std::vector<BenchSweep::Place> places) { return {0.5, "", std::move(places)}; }

TEST(Verdict, NamesTheRangesWhereAMethodIsWrong) {
    EXPECT_EQ(verdict_of(sweep_of({{1, 0.1}, {10, 0.5}}), "degree"), "keeps 0.5 degrees for all inputs of this sweep.");
    EXPECT_EQ(verdict_of(sweep_of({{1, 0.1}, {10, 0.6}, {100, 9}}), "degree"),
              "off by more than 0.5 degrees from 10 on.");
    EXPECT_EQ(verdict_of(sweep_of({{1, 2}, {10, 0.1}, {100, 0.1}}), "degree"), "off by more than 0.5 degrees up to 1.");
    EXPECT_EQ(verdict_of(sweep_of({{1, 2}, {10, 2}}), "degree"), "off by more than 0.5 degrees everywhere.");
    EXPECT_EQ(verdict_of(sweep_of({{1, 0}, {10, 2}, {100, 0}}), "degree"), "off by more than 0.5 degrees at 10.");
    EXPECT_EQ(verdict_of(sweep_of({{1, 0}, {10, 2}, {100, 3}, {1e3, 0}, {1e4, 4}}), "degree"),
              "off by more than 0.5 degrees from 10 to 100 and from 10000 on.");
}

TEST(Verdict, NamesNonFiniteAndEndlessRangesAsWell) {
    EXPECT_EQ(verdict_of(sweep_of({{1, 0}, {10, 2}, {100, 0, 0.5}}), "texel"),
              "off by more than 0.5 texels at 10, not finite from 100 on.");
    EXPECT_EQ(verdict_of(sweep_of({{1, 0}, {10, 0, 0, 0.01}}), "texel"), "does not end from 10 on.");
    BenchSweep sweep = sweep_of({{1, 9}});
    sweep.why = "A float has 24 digits.";
    EXPECT_EQ(verdict_of(sweep, "texel"), "off by more than 0.5 texels everywhere. A float has 24 digits.");
}

TEST(Swept, CountsFailedPlacesAndAveragesTheErrorOfTheOthers) {
    const BenchSubject subject = swept(sweep_of({{1, 0.1}, {10, 0.3}, {100, 7}, {1e3, 0, 1}, {1e4, 0, 0, 1}}), "texel");
    EXPECT_EQ(subject.work, (BenchWork{{"wrong", 1}, {"not_finite", 1}, {"endless", 1}}));
    EXPECT_DOUBLE_EQ(subject.error.mean, 0.2);
    EXPECT_DOUBLE_EQ(subject.error.largest, 0.3);
    EXPECT_DOUBLE_EQ(swept(sweep_of({{1, 2}, {10, 4}}), "texel").error.mean, 3) << "where nothing holds: of all";
}

TEST(Tally, SeparatesErrorsFromNonFiniteAndEndlessOnes) {
    Tally tally;
    for (const double error : {1.0, 3.0, double(NAN), double(INFINITY)}) tally.add(error);
    tally.endless();
    EXPECT_EQ(tally.mean(7).hardness, 7);
    EXPECT_EQ(tally.mean(7).error, 2);
    EXPECT_EQ(tally.largest(7).error, 3);
    EXPECT_EQ(tally.mean(7).not_finite, 0.4);
    EXPECT_EQ(tally.mean(7).endless, 0.2);
}

BenchScene two_methods() {
    const auto at = [](double hard) { return BenchSweep::Place{hard, hard / 10, hard > 50 ? 1.0 : 0.0}; };
    return sweep_scene("needles", "length", "degree", {1, 10, 100},
                       {{"one", 0.5, "Why.", at}, {"other", 5, "", at, true}});
}

TEST(SweepScene, IsMeasuredInAProcessWithoutTimesAndWrittenWithItsPlaces) {
    const BenchTopic topic{"topic", "help", "question?", {}, false, false, true};
    BenchMachine machine;
    const auto rows = run_scene(topic, two_methods(), {.settings = {.repeats = 0}}, machine);
    ASSERT_EQ(rows.size(), 2u);
    ASSERT_TRUE(rows[0].is_measured() && rows[0].sweep) << rows[0].state;
    ASSERT_EQ(rows[0].sweep->places.size(), 3u);
    EXPECT_EQ(rows[0].sweep->places[1].error, 1);
    EXPECT_EQ(rows[0].sweep->places[2].not_finite, 1);
    const std::string csv = bench_csv(rows, machine), table = bench_table(topic, rows, machine);
    EXPECT_TRUE(contains(csv, ",0.5,1:0.1 10:1 100:not-finite,")) << csv;
    EXPECT_TRUE(contains(table, "off by more than 0.5 degrees at 10, not finite from 100 on. Why.")) << table;
    EXPECT_EQ(row_name(read_bench_csv(csv)[1]), row_name(rows[1]));

    const std::string script = sweep_script(rows, {0, 1}, {.size = {740, 536}, .title = 24, .axes = 24, .names = 24});
    EXPECT_TRUE(contains(script, "set title \"needles\"") && contains(script, "set logscale xy")) << script;
    EXPECT_TRUE(contains(script, "#0 one at 100: 100 % not finite")) << script;
    EXPECT_TRUE(contains(script, "'none'")) << script;
}

TEST(Stability, TangentsAreStableWherePeersAre) { expect_course_holds_where_peers_do(tangent_sweeps({.quick = true})); }
TEST(Stability, FormatsAndAnglesAreStableWherePeersAre) {
    expect_course_holds_where_peers_do(codec_sweeps({.quick = true}));
}
TEST(Stability, NormalsFromHeightsAreStableWherePeersAre) {
    expect_course_holds_where_peers_do(height_sweeps({.quick = true}));
}
TEST(Stability, LayersAndGuessedShadowsAreStableWherePeersAre) {
    expect_course_holds_where_peers_do(layer_sweeps({.quick = true}));
}

TEST(Stability, LayersAndGuessedShadowsKeepTheirStatedErrorsWherePeersFail) {
    for (const BenchScene& scene : layer_sweeps({.quick = true}))
        for (const BenchMethod& method : scene.methods) {
            const BenchSweep sweep = method.prepare().sweep.value();
            const bool keeps = std::all_of(sweep.places.begin(), sweep.places.end(),
                                           [&](const BenchSweep::Place& place) { return holds(sweep, place); });
            EXPECT_NE(keeps, method.peer) << knob_text(scene.knobs) << ", " << method.name;
        }
}

}  // namespace
}  // namespace relief::measure
