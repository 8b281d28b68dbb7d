// relief bench: its scenes in separate processes, its output, and the baseline of work.
#include "framework/staff/measure/run.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <csignal>

#include "framework/staff/measure/baseline.h"
#include "framework/staff/measure/plot.h"
#include "tests/support.h"

namespace relief::measure {
namespace {

using namespace std::string_literals;

BenchMethod good(const std::string& name, double error = 1) {
    return {name, {{"steps", "8"}}, [error] {
                return BenchSubject{
                    .items = 2, .work = {{"taps", 3}}, .error = {error, error, error, "texel"}, .run = [] {}};
            }};
}

/// Runs a scene of these methods. Each method runs in its own process, so its changes of memory are invisible here.
std::vector<BenchRow> run(const std::vector<BenchMethod>& methods, int repeats = 2) {
    const BenchTopic topic{"topic", "help", "question?", {}};
    BenchMachine machine;
    return run_scene(topic, {{{"map", "bricks"}}, "frame", methods}, {.settings = {.repeats = repeats}}, machine);
}

TEST(RunScene, ReportsTimesErrorAndWorkOfEachMethod) {
    const auto rows = run({good("one", 0.5), good("two")}, 3);
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_TRUE(rows[0].is_measured());
    EXPECT_EQ(rows[0].method, "one");
    EXPECT_EQ(rows[0].error.mean, 0.5);
    EXPECT_EQ(rows[0].work, (BenchWork{{"taps", 3}}));
    EXPECT_EQ(rows[1].repeats, 3);
    EXPECT_GT(rows[1].times.median, 0);
}

TEST(RunScene, TimesByProcessorTimeUnlessOtherThreadsDoTheWork) {
    const BenchMethod parallel{"parallel", {}, [] { return BenchSubject{.run = [] {}, .is_parallel = true}; }};
    const auto rows = run({good("one"), parallel});
    EXPECT_EQ(rows[0].clock, "cpu");
    EXPECT_EQ(rows[1].clock, "wall");
    EXPECT_EQ(clocks_of(rows), "cpu and wall");
}

/// Ends the process by a signal, even with a sanitizer, which would otherwise catch the signal.
void crash(int signal) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

TEST(RunScene, ACrashIsReportedInItsRowAndOthersContinue) {
    // Crashes during preparation, and during timing.
    const BenchMethod early{"early", {}, []() -> BenchSubject {
                                crash(SIGSEGV);
                                return {};
                            }};
    const BenchMethod late{"late", {}, [] { return BenchSubject{.run = [] { crash(SIGFPE); }}; }};
    const auto rows = run({good("one"), early, late, good("two")});
    EXPECT_TRUE(contains(rows[1].state, "crashed: Segmentation fault")) << rows[1].state;
    EXPECT_TRUE(contains(rows[2].state, "crashed: Floating point exception")) << rows[2].state;
    for (const size_t i : {0u, 3u}) {
        EXPECT_TRUE(rows[i].is_measured()) << rows[i].state;
        EXPECT_EQ(rows[i].repeats, 2);
    }
}

TEST(RunScene, AnExceptionIsReportedInItsRow) {
    const BenchMethod early{"early", {}, []() -> BenchSubject { throw Error("no such map"); }};
    const BenchMethod late{"late", {}, [] {
                               return BenchSubject{.run = [calls = 0]() mutable {
                                   if (++calls > 3) throw Error("worn out");
                               }};
                           }};
    const auto rows = run({early, good("one"), late});
    EXPECT_EQ(rows[0].state, "failed: no such map");
    EXPECT_EQ(rows[2].state, "failed: worn out");
    EXPECT_EQ(rows[2].repeats, 0) << "times of a method that has failed are none";
    EXPECT_TRUE(rows[1].is_measured());
    EXPECT_EQ(rows[1].repeats, 2);
}

TEST(RunScene, ANonFiniteErrorIsReportedInItsRow) {
    const auto rows = run({good("nan", std::nan("")), good("infinite", INFINITY), good("one")});
    for (const size_t i : {0u, 1u}) EXPECT_TRUE(contains(rows[i].state, "not a number")) << rows[i].state;
    EXPECT_TRUE(rows[2].is_measured());
}

TEST(RunScene, ReportsAfterEveryStep) {
    const BenchTopic topic{"topic", "help", "question?", {}};
    const BenchScene scene{{}, "frame", {good("one"), good("two")}};
    const BenchSettings settings{.repeats = 2};
    BenchMachine machine;
    int reports = 0, measured_first = -1;
    run_scene(topic, scene,
              {.settings = settings,
               .report =
                   [&](const std::vector<BenchRow>& rows, const std::string&) {
                       if (++reports == 2) measured_first = int(rows[0].is_measured()) + int(rows[1].is_measured());
                   }},
              machine);
    EXPECT_EQ(reports, steps_of(scene, settings));
    EXPECT_EQ(measured_first, 1) << "the first method is known before the second is begun";
}

TEST(RunScene, ReturnsThePictures) {
    const BenchMethod method{"seen", {}, [] {
                                 Image picture(2, 1, 3, 8);
                                 picture.values = {0, 1, 0.2f, 0.4f, 0.6f, 0.8f};
                                 return BenchSubject{.run = [] {}, .picture = picture};
                             }};
    const auto rows = run({method});
    ASSERT_EQ(rows[0].picture.width, 2);
    for (size_t i = 0; i < 6; ++i)
        EXPECT_NEAR(rows[0].picture.values[i], (std::vector{0., 1., .2, .4, .6, .8})[i], 1e-6);
    EXPECT_EQ(rows[0].error_map.width, 0);
}

BenchRow row_of(const std::string& method, double taps, double error) {
    BenchRow row;
    row.topic = "parallax", row.scene = {{"map", "bricks"}}, row.method = method, row.item = "frame";
    row.knobs = {{"squares", "4 x 4"}}, row.state = "measured", row.work = {{"taps", taps}};
    row.error = {error, 2 * error, 3 * error, "texel", 0.25};
    return row;
}

TEST(BenchCsv, RoundTripsThroughText) {
    const std::vector<BenchRow> rows = {row_of("one, \"two\"", 7.25, 0.125)};
    const auto read = read_bench_csv(bench_csv(rows, {}));
    ASSERT_EQ(read.size(), 1u);
    EXPECT_EQ(row_name(read[0]), row_name(rows[0]));
    EXPECT_EQ(read[0].work, rows[0].work);
    EXPECT_EQ(read[0].error.p99, 0.25);
    EXPECT_EQ(read[0].error.wrong, 0.25);
}

TEST(BenchCsv, ABrokenFileIsAnErrorWithItsLine) {
    const std::string text = bench_csv(std::vector{row_of("one", 1, 1), row_of("two", 1, 1)}, {});
    EXPECT_THROW(read_bench_csv(""), Error);
    EXPECT_THROW(read_bench_csv("a,b\n1,2\n"), Error);
    try {
        read_bench_csv(text.substr(0, text.size() - 20));  // as a full disk leaves it
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.place().line, 3);
    }
}

TEST(Baseline, AcceptsEqualOrSmallerValues) {
    const std::vector<BenchRow> before = {row_of("a", 100, 1)};
    EXPECT_TRUE(compare_with_baseline(before, before, 0.02).worse.empty());
    const auto less = compare_with_baseline(std::vector{row_of("a", 90, 0.5)}, before, 0.02);
    EXPECT_TRUE(less.worse.empty());
    EXPECT_EQ(less.better.size(), 3u) << "taps, and the error's mean and 99th percentile";
}

TEST(Baseline, FailsWhenWorkOrErrorGrows) {
    const std::vector<BenchRow> before = {row_of("a", 100, 1)};
    const auto work = compare_with_baseline(std::vector{row_of("a", 103, 1)}, before, 0.02);
    ASSERT_EQ(work.worse.size(), 1u);
    EXPECT_TRUE(contains(work.worse[0], "taps 103, was 100")) << work.worse[0];
    EXPECT_TRUE(compare_with_baseline(std::vector{row_of("a", 101, 1.01)}, before, 0.02).worse.empty());
    EXPECT_EQ(compare_with_baseline(std::vector{row_of("a", 100, 1.1)}, before, 0.02).worse.size(), 2u);
    EXPECT_FALSE(compare_with_baseline(std::vector{row_of("a", std::nan(""), 1)}, before, 0.02).worse.empty());
}

TEST(Baseline, FailsForNewMissingOrFailedRows) {
    const std::vector<BenchRow> before = {row_of("a", 100, 1)};
    const auto other = compare_with_baseline(std::vector{row_of("b", 100, 1)}, before, 0.02);
    ASSERT_EQ(other.worse.size(), 2u);
    EXPECT_TRUE(contains(other.worse[0], "not in the baseline"));
    EXPECT_TRUE(contains(other.worse[1], "not measured"));
    std::vector<BenchRow> broken = before;
    broken[0].state = "failed: no such map";
    EXPECT_EQ(compare_with_baseline(broken, before, 0.02).worse.size(), 1u);
}

std::vector<BenchRow> timed_rows() {
    std::vector<BenchRow> rows;
    for (const auto& [method, time, error] :
         {std::tuple{"quick", 1e6, 1.}, {"good", 4e6, 0.01}, {"dominated", 5e6, 0.5}, {"exact", 9e6, 0.}}) {
        rows.push_back(row_of(method, 1, error));
        rows.back().times = {time, time * 0.9, time * 1.2}, rows.back().repeats = 10;
    }
    return rows;
}

TEST(ParetoFront, ContainsThePointsThatNoOtherDominates) {
    const std::vector<std::pair<double, double>> points = {{1, 5}, {2, 3}, {3, 3}, {4, 1}, {4, 1}, {5, 2}};
    EXPECT_EQ(pareto_front(points), (std::vector<bool>{true, true, false, true, true, false}));
    const auto rows = timed_rows();
    EXPECT_EQ(front_of(rows, {0, 1, 2, 3}), (std::vector<size_t>{0, 1, 3}));
}

TEST(BenchPlot, LabelsEveryPoint) {
    const BenchTopic topic{"parallax", "help", "Which & why?", {}};
    const auto plot = slide_plot(topic, timed_rows(), false);
    ASSERT_TRUE(plot) << "gnuplot (Debian package gnuplot-nox) is missing";
    EXPECT_TRUE(contains(*plot, "<svg"));
    for (const char* name : {"quick", "good", "dominated", "exact"})
        EXPECT_TRUE(contains(*plot, "<title>parallax, map=bricks, "s + name + ", squares=4 x 4</title>")) << name;
    EXPECT_TRUE(contains(*plot, "class=\"point\" data-row=\"3\""));
    EXPECT_FALSE(contains(*plot, "gnuplot_svg")) << "no script that is not there";
    EXPECT_TRUE(contains(*plot, "<title>Which &amp; why?</title>"));
    EXPECT_FALSE(contains(*plot, "<title>Gnuplot")) << "a screen reader would say so";
}

TEST(BenchPlot, NamesItsAxesAtAnySizeAndForAnyErrors) {
    for (const double error : {1e-9, 1e-4, 0.01, 1e5})
        for (const PlotStyle& style : {PlotStyle{.size = {1136, 460}, .title = 24, .axes = 24, .names = 24},
                                       PlotStyle{.size = {1100, 560}, .title = 0, .axes = 18, .names = 18},
                                       PlotStyle{.size = {324, 400}, .title = 0, .axes = 15, .names = 15}}) {
            auto rows = timed_rows();
            rows[1].error.mean = error;
            const auto plot = scene_plot({"parallax", "help", "question?", {}}, rows, {0, 1, 2, 3}, style, "name");
            ASSERT_TRUE(plot);
            EXPECT_TRUE(contains(*plot, "mean error, ")) << error << ", " << style.axes;
            EXPECT_TRUE(contains(*plot, "ms per ")) << error << ", " << style.axes;
            EXPECT_EQ(contains(*plot, ">map=bricks"), style.title > 0) << error << ", " << style.axes;
        }
}

TEST(BenchPlot, OfSeveralScenesIsThatWithMostToCompareAndNamesAQuickRun) {
    std::vector<BenchRow> rows = timed_rows();
    for (BenchRow row : timed_rows()) rows.push_back(row), rows.back().scene = {{"map", "posts"}};
    rows[0].error = rows[1].error = rows[2].error = {};  // of the first scene only one has an error
    for (const bool is_quick : {false, true}) {
        const auto plot = slide_plot({"parallax", "help", "question?", {}}, rows, is_quick);
        ASSERT_TRUE(plot);
        EXPECT_TRUE(contains(*plot, "map=posts"));
        EXPECT_FALSE(contains(*plot, "map=bricks"));
        EXPECT_EQ(contains(*plot, "quick run"), is_quick);
    }
}

TEST(BenchPlot, DrawsBarsIfThereAreOnlyTimes) {
    auto rows = timed_rows();
    for (BenchRow& row : rows) row.error = {};
    const auto plot = slide_plot({"grade", "help", "question?", {}}, rows, false);
    ASSERT_TRUE(plot);
    EXPECT_TRUE(contains(*plot, "data-row=\"2\""));
    EXPECT_FALSE(contains(*plot, "mean error"));
    for (BenchRow& row : rows) row.repeats = 0;
    EXPECT_EQ(slide_plot({"grade", "help", "question?", {}}, rows, false), "") << "nothing was timed";
}

TEST(BenchPlot, DrawsTimesHollowThatSpreadByMoreThanAFactorOf2) {
    constexpr const char* key = "hollow: p90 over twice p10";
    for (const bool has_error : {true, false}) {
        auto rows = timed_rows();
        if (!has_error)
            for (BenchRow& row : rows) row.error = {};
        const auto narrow = slide_plot({"grade", "help", "question?", {}}, rows, false);
        rows[1].times.p90 = 2.1 * rows[1].times.p10;
        const auto wide = slide_plot({"grade", "help", "question?", {}}, rows, false);
        ASSERT_TRUE(narrow && wide);
        EXPECT_FALSE(contains(*narrow, key));
        EXPECT_TRUE(contains(*wide, key));
        EXPECT_TRUE(contains(*wide, "good, squares=4 x 4, p90 over twice p10</title>"));
        for (size_t i = 0; i < rows.size(); ++i)
            EXPECT_TRUE(contains(*wide, fmt::format("data-row=\"{}\"", i))) << "no point is lost";
    }
}

BenchTopic sweep() {
    return {
        "parallax", "help", "question?", [](const BenchSettings&) {
            std::vector<BenchScene> scenes;
            for (const char* map : {"bricks", "posts"})
                scenes.push_back(
                    {{{"map", map}}, "frame", {{"linear", {{"steps", "8"}}}, {"linear", {{"steps", "16"}}}, {"walk"}}});
            return scenes;
        }};
}

std::vector<std::string> left_of(const std::vector<std::pair<std::string, std::vector<std::string>>>& wanted) {
    std::vector<std::string> names;
    for (const BenchScene& scene : filter_scenes(sweep(), sweep().scenes({}), wanted))
        for (const BenchMethod& method : scene.methods)
            names.push_back(scene.knobs[0].second + " " + method.name + " " + knob_text(method.knobs));
    return names;
}

TEST(Only, KeepsMethodsWithTheGivenValues) {
    EXPECT_EQ(left_of({}).size(), 6u);
    EXPECT_EQ(left_of({{"map", {"posts"}}, {"steps", {"16"}}}), std::vector<std::string>{"posts linear steps=16"});
    EXPECT_EQ(left_of({{"method", {"walk"}}}), (std::vector<std::string>{"bricks walk ", "posts walk "}));
    EXPECT_EQ(left_of({{"steps", {"8", "16"}}}).size(), 4u);
}

TEST(Only, AnImpossibleKnobOrValueIsOneLine) {
    const auto message = [](const std::string& knob, const std::string& value) -> std::string {
        try {
            left_of({{knob, {value}}});
        } catch (const UsageError& error) {
            return error.what();
        }
        return "nothing was thrown";
    };
    EXPECT_EQ(message("map", "brick"), "parallax does not measure map = 'brick': choose from bricks, posts");
    EXPECT_TRUE(contains(message("stepz", "8"), "did you mean 'steps'")) << message("stepz", "8");
}

}  // namespace
}  // namespace relief::measure
