// The harness of relief bench: error figures, timing rounds, and its output files.
#include "framework/staff/measure/rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <thread>

#include "framework/core/base/text.h"
#include "framework/staff/class/csv.h"
#include "framework/staff/measure/answer.h"
#include "framework/staff/measure/memory.h"
#include "framework/staff/measure/peers.h"
#include "framework/staff/measure/plot.h"
#include "framework/staff/measure/tangents_topic.h"
#include "tests/support.h"

namespace relief::measure {
namespace {

TEST(Quantile, InterpolatesBetweenTwoValues) {
    EXPECT_EQ(quantile({3, 1, 2}, 0.5), 2);
    EXPECT_EQ(quantile({4, 1, 3, 2}, 0.5), 2.5);
    EXPECT_EQ(quantile({7}, 0.9), 7);
    EXPECT_EQ(quantile({0, 10}, 0.1), 1);
    EXPECT_EQ(quantile({5, 1}, 0), 1);
    EXPECT_EQ(quantile({5, 1}, 1), 5);
}

TEST(ErrorFigures, AreMeanLargestAndThe99thPercentile) {
    std::vector<double> errors;
    for (int i = 0; i <= 100; ++i) errors.push_back(i);
    const BenchError error = error_figures(errors, "degree");
    EXPECT_EQ(error.mean, 50);
    EXPECT_EQ(error.p99, 99);
    EXPECT_EQ(error.largest, 100);
    EXPECT_EQ(error_figures({}, "degree").largest, 0);
}

TEST(PeakGrowth, IsTheMemoryThatAFunctionTakesThoughItFreesItAndThoughAnotherTookMoreBefore) {
    const auto mebibytes_of = [](size_t taken) {
        return double(peak_growth([taken] {
                   std::vector<char> memory((taken << 20) + 1, 1);
                   EXPECT_EQ(memory.back(), 1);
               })) /
               (1 << 20);
    };
    EXPECT_NEAR(mebibytes_of(64), 70, 10) << "a sanitizer adds an eighth";
    EXPECT_NEAR(mebibytes_of(16), 18, 6);
    EXPECT_LT(mebibytes_of(0), 4);
}

/// A clock that moves only when a method runs.
struct Machine {
    double now = 0;
    std::vector<std::string> ran;
    BenchSubject subject(const std::string& name, double seconds) {
        return {.items = 10, .run = [this, name, seconds] { now += seconds, ran.push_back(name); }};
    }
    std::vector<BenchTimes> time(std::vector<BenchSubject> subjects, int repeats) {
        BenchTurns turns(subjects, [this](const BenchSubject& subject, size_t times) {
            const double begin = now;
            for (size_t i = 0; i < times; ++i) subject.run();
            return now - begin;
        });
        for (int i = 0; i < repeats; ++i) turns.round();
        return turns.times();
    }
};

TEST(BenchTurns, ReportNanosecondsPerItem) {
    Machine machine;
    const auto times = machine.time({machine.subject("slow", 0.5), machine.subject("quick", 0.01)}, 3);
    EXPECT_NEAR(times[0].median, 0.5e9 / 10, 1);
    EXPECT_NEAR(times[1].median, 0.01e9 / 10, 1);
    EXPECT_NEAR(times[0].p10, times[0].p90, 1);
}

TEST(BenchTurns, RunAllMethodsInEachRoundInChangingOrder) {
    Machine machine;
    machine.time({machine.subject("a", 1), machine.subject("b", 1), machine.subject("c", 1)}, 8);
    ASSERT_EQ(machine.ran.size(), 6u + 24u) << "twice to warm up, then once a round";
    std::map<std::string, int> rounds;
    for (size_t round = 6; round < machine.ran.size(); round += 3) {
        std::vector<std::string> three(machine.ran.begin() + long(round), machine.ran.begin() + long(round) + 3);
        ++rounds[three[0] + three[1] + three[2]];
        std::sort(three.begin(), three.end());
        EXPECT_EQ(three, (std::vector<std::string>{"a", "b", "c"}));
    }
    EXPECT_GT(rounds.size(), 1u);
}

TEST(BenchTurns, RepeatRunsShorterThanAMillisecond) {
    Machine machine;
    const auto times = machine.time({machine.subject("short", 1e-5)}, 1);
    EXPECT_GE(machine.ran.size(), 100u);
    EXPECT_NEAR(times[0].median, 1e-5 * 1e9 / 10, 1e-3);
}

TEST(BenchTurns, SpreadADriftOfTheMachineOverAllMethods) {
    // Each run takes slightly longer than the one before. The medians differ by less than that drift.
    Machine machine;
    double slower = 1;
    const auto drifting = [&] { return BenchSubject{.run = [&] { machine.now += slower, slower *= 1.01; }}; };
    const auto times = machine.time({drifting(), drifting()}, 40);
    EXPECT_NEAR(times[0].median / times[1].median, 1, 0.03);
}

TEST(BenchClock, OfTheProcessorCountsNoTimeInWhichOtherProgramsRun) {
    // A sleeping thread loses the processor as it does to other programs.
    const auto sleep = [] { std::this_thread::sleep_for(std::chrono::milliseconds(20)); };
    EXPECT_LT(by_cpu_clock(sleep, 2), 0.5 * by_wall_clock(sleep, 2));
    double sum = 0;
    const auto compute = [&] {
        for (int i = 1; i < 100'000; ++i) sum += std::sqrt(i);
    };
    EXPECT_GT(by_cpu_clock(compute, 1), 0);
    EXPECT_GT(sum, 0);
}

BenchRow measured(const std::string& method) {
    BenchRow row;
    row.topic = "topic", row.method = method, row.item = "texel", row.state = "measured", row.repeats = 9;
    row.times = {4.5, 3, 5}, row.clock = "cpu";
    return row;
}

TEST(BenchCsv, HasAFieldForEachColumnForAnyText) {
    std::vector<BenchRow> rows = {measured("plain, \"quoted\""), measured("peer"), measured("broken")};
    rows[0].knobs = {{"a", "1"}, {"b", "2"}}, rows[0].items = 7, rows[0].bytes_per_item = 16;
    rows[0].error = {1, 2, 3, "degree"}, rows[0].work = {{"taps", 1398101}, {"visits", 2.5}};
    rows[1].times.p90 = 6.5, rows[1].clock = "wall";
    rows[2].state = "crashed: a, b", rows[2].repeats = 0;
    const grade::CsvTable table = grade::parse_csv(
        bench_csv(rows, {.cpu = "A, CPU", .compiler = "gcc", .commit = "abc", .load = 7.5, .processors = 2}),
        "bench.csv");
    ASSERT_EQ(table.rows.size(), 3u);
    const auto field = [&](size_t row, const char* name) {
        return table.cell(table.rows[row], name);  // run_test.cpp counts the fields
    };
    EXPECT_EQ(field(0, "method"), "plain, \"quoted\"");
    EXPECT_EQ(field(0, "knobs"), "a=1 b=2");
    EXPECT_EQ(field(0, "repeats"), "9");
    EXPECT_EQ(field(0, "ns_per_item_p90"), "5");
    EXPECT_EQ(field(0, "error_p99"), "2");
    EXPECT_EQ(field(0, "work"), "taps=1398101 visits=2.5");
    EXPECT_EQ(field(0, "cpu"), "A, CPU");
    EXPECT_EQ(field(0, "clock") + field(1, "clock"), "cpuwall");
    EXPECT_EQ(field(0, "spread"), "");
    EXPECT_EQ(field(1, "spread"), "wide") << "from 3 to 6.5";
    EXPECT_EQ(field(0, "load") + " on " + field(0, "processors"), "7.5 on 2");
    EXPECT_EQ(field(1, "error_mean"), "") << "a peer makes no claim";
    EXPECT_EQ(field(1, "bytes_per_item"), "");
    EXPECT_EQ(field(2, "state"), "crashed: a, b");
    EXPECT_EQ(field(2, "ns_per_item_median"), "") << "what has failed has no time";
}

TEST(BenchTable, ShowsEveryMethodWithItsFigures) {
    std::vector<BenchRow> rows = {measured("one"), measured("two")};
    rows[0].knobs = {{"threads", "2"}}, rows[0].error = {0.125, 2, 3, "degree"};
    rows[1].state = "failed: no such map";
    const std::string table = bench_table({"topic", "what it is about", "question?", {}}, rows, {});
    for (const char* part :
         {"what it is about", "one", "threads=2", "ns/texel", "4.5", "mean degree", "0.125", "failed: no such map"})
        EXPECT_TRUE(contains(table, part)) << part;
}

TEST(BenchTable, MarksTimesThatSpreadByMoreThanAFactorOf2AndPrintsTheLoad) {
    const BenchTopic topic{"topic", "what it is about", "question?", {}};
    std::vector<BenchRow> rows = {measured("narrow"), measured("limit"), measured("wide")};
    rows[1].times.p90 = 6, rows[2].times.p90 = 6.1;
    const std::string table = bench_table(topic, rows, {.load = 7.123, .processors = 2});
    std::vector<std::string> starred;
    for (const std::string& line : split(table, '\n'))
        if (line.ends_with(" *")) starred.push_back(line.substr(0, line.find(' ')));
    EXPECT_EQ(starred, std::vector<std::string>{"wide"}) << table;
    EXPECT_TRUE(contains(table, "* p90 is more than twice p10")) << table;
    EXPECT_TRUE(contains(table, "load 7.1 on 2 processors")) << table;
    rows.pop_back();
    EXPECT_FALSE(contains(bench_table(topic, rows, {}), "*")) << "nothing is marked";
}

TEST(BenchRow, NamesTheNumbersAmongItsKnobs) {
    BenchRow row = measured("mikktspace");
    row.knobs = {{"threads", "2"}, {"map_size", "64"}, {"wears", "map"}};
    EXPECT_EQ(short_name(row), "mikktspace 2 threads map size 64 map");
    row.knobs = {{"threads", "1"}};
    EXPECT_EQ(short_name(row), "mikktspace 1 thread");
    row.knobs = {{"makes", "mikktspace"}, {"gram_schmidt", "on"}, {"scaled", "no"}};
    EXPECT_EQ(short_name(row), "mikktspace gram schmidt no scaled");
}

/// A row with a median time, its spread to both sides, and a mean error.
BenchRow timed_row(const char* method, double median, double spread, double error) {
    BenchRow row;
    row.topic = "parallax", row.method = method, row.item = "frame", row.state = "measured", row.repeats = 15;
    row.times = {median, median - spread, median + spread};
    row.error = {error, error, error, "texel", {}};
    return row;
}

std::string answer_of_all(const std::vector<BenchRow>& rows) { return answer_of(rows, scenes_of(rows).front()); }

TEST(BenchAnswer, CallsMethodsWithOverlappingTimesAboutEqual) {
    const std::string text = answer_of_all({timed_row("linear-16", 1.0e6, 1e5, 0.5),
                                            timed_row("linear-8", 1.1e6, 1e5, 1), timed_row("exact", 3e6, 1e5, 0)});
    EXPECT_TRUE(contains(text, "The fastest: linear-16 (1 ms, mean error 0.5 texels). About as fast: linear-8."))
        << text;
    EXPECT_TRUE(contains(text, "The most accurate: exact (3 ms, mean error 0 texels), 3 times as long.")) << text;
}

TEST(BenchAnswer, ComparesTimesThatDoNotOverlap) {
    const std::string text =
        answer_of_all({timed_row("linear-16", 1.0e6, 1e4, 0.5), timed_row("linear-8", 0.9e6, 1e4, 1)});
    EXPECT_TRUE(contains(text, "The fastest: linear-8")) << text;
    EXPECT_FALSE(contains(text, "About as fast")) << text;
    const std::string equal = answer_of_all({timed_row("a", 1.0e6, 1e5, 0.5), timed_row("b", 1.1e6, 1e5, 0.4)});
    EXPECT_TRUE(
        contains(equal, "The most accurate: b (1.1 ms, mean error 0.4 texels), not clearly longer in this run."))
        << equal;
}

TEST(BenchAnswer, OfEqualErrorsTheFastestIsTheMostAccurate) {
    const std::string text = answer_of_all({timed_row("windows", 1e6, 1e4, 0.0000218), timed_row("quick", 5e5, 1e4, 1),
                                            timed_row("max-mips", 2e6, 1e4, 0.00002179)});
    EXPECT_TRUE(contains(text, "The most accurate: windows")) << text;
}

TEST(BenchAnswer, OfTimesAloneNamesNoFastestWithinTheSpread) {
    std::vector<BenchRow> rows = {timed_row("a", 1.0e6, 1e5, 0), timed_row("b", 1.1e6, 1e5, 0)};
    for (BenchRow& row : rows) row.error = {};
    EXPECT_EQ(answer_of_all(rows), "All 2 methods take about as long: 1 ms to 1.1 ms a frame.");
    rows.push_back(timed_row("c", 3e6, 2.5e6, 0)), rows.back().error = {};
    EXPECT_EQ(answer_of_all(rows), "The times of 3 methods cannot be told apart in this run: 1 ms to 3 ms a frame.");
}

TEST(BenchAnswer, SaysThatWideTimesCannotBeToldApart) {
    // Medians of a busy machine: 191 ns and 13.5 ns, with overlapping spreads.
    BenchRow fast = timed_row("quick", 13.5, 0, 1), slow = timed_row("slow", 191, 0, 0.5);
    fast.times = {13.5, 13, 240}, slow.times = {191, 35, 1338};
    const std::string text = answer_of_all({fast, slow});
    EXPECT_FALSE(contains(text, "bout as")) << text;
    EXPECT_TRUE(contains(text, "Cannot be told apart from it in this run: slow.")) << text;
    EXPECT_TRUE(contains(text, "slow (191 ns, mean error 0.5 texels), a time that cannot be told apart in this run"))
        << text;
}

TEST(BenchAnswer, CallsNoMediansAboutEqualThatDifferByMoreThanAFactorOf2) {
    // Neither spread is wide, and they overlap.
    BenchRow fast = timed_row("quick", 1e6, 0, 1), slow = timed_row("slow", 2.05e6, 0, 0.5);
    fast.times = {1e6, 0.8e6, 1.5e6}, slow.times = {2.05e6, 1.4e6, 2.1e6};
    EXPECT_FALSE(contains(answer_of_all({fast, slow}), "bout as"));
}

TEST(BenchTopics, HaveMethodsThatRunAndMeasureErrors) {
    for (const BenchTopic& topic : bench_topics()) {
        // This program has no context and no labs. The test `baseline` runs the other topics.
        if (topic.draws || topic.only_time) continue;
        size_t with_error = 0;
        for (const BenchScene& scene : topic.scenes({.repeats = 1, .quick = true}))
            for (const BenchMethod& method : scene.methods) {
                const BenchSubject subject = method.prepare();
                subject.run();
                with_error += !subject.error.unit.empty();
                EXPECT_TRUE(std::isfinite(subject.error.largest)) << topic.name << " " << method.name;
                EXPECT_LE(subject.error.mean, subject.error.largest) << topic.name << " " << method.name;
                EXPECT_GT(subject.items, 0u);
            }
        EXPECT_GT(with_error, 0u) << topic.name;
    }
}

TEST(BenchTopics, MeasureTangentsOnATorusWithoutAFoldedTriangle) {
    for (const auto& [columns, rows] : {std::pair(64, 32), {250, 100}, {1000, 500}}) {
        const Mesh mesh = bench_torus(columns, rows);
        size_t folded = 0;
        for (size_t i = 0; i < mesh.indices.size(); i += 3) {
            const auto at = [&](size_t k) { return mesh.vertices[mesh.indices[i + k]]; };
            const glm::dvec3 p(at(0).position);
            const glm::dvec3 across = glm::cross(glm::dvec3(at(1).position) - p, glm::dvec3(at(2).position) - p);
            const glm::dvec2 uv(at(0).uv), one = glm::dvec2(at(1).uv) - uv, two = glm::dvec2(at(2).uv) - uv;
            folded += glm::dot(across, glm::dvec3(at(0).normal)) <= 0 || one.x * two.y - one.y * two.x <= 0;
        }
        EXPECT_EQ(folded, 0u) << columns << " x " << rows;
    }
}

/// Prepares a method of a topic, in its quick sweep.
BenchSubject prepared(const std::string& topic_name, const std::string& method_name) {
    for (const BenchTopic& topic : bench_topics())
        if (topic.name == topic_name)
            for (const BenchScene& scene : topic.scenes({.repeats = 1, .quick = true}))
                for (const BenchMethod& method : scene.methods)
                    if (method.name == method_name) return method.prepare();
    throw std::runtime_error(topic_name + " has no " + method_name);
}

TEST(Peers, ComputeTheComparedQuantities) {
    ASSERT_TRUE(has_peers()) << "built without libassimp-dev or libembree-dev";
    // The peers are less accurate, but they compute the tangents of this mesh and the slopes of this map. Other units,
    // signs or orders would give errors of tens of degrees.
    const BenchError tangents = prepared("tangents", "Assimp").error, slopes = prepared("normals", "OpenImageIO").error;
    EXPECT_LT(tangents.mean, 3);
    EXPECT_GT(tangents.mean, 0.1);
    EXPECT_LT(slopes.mean, 2.5);
    EXPECT_GT(slopes.mean, 1);
    const BenchError hits = prepared("intersection", "Embree").error;
    EXPECT_LT(hits.p99, 1e-5);
    EXPECT_GT(hits.p99, 1e-9) << "single precision";
    EXPECT_LT(hits.wrong.value_or(1), 0.005) << "rays that slip through a vertex, although it is robust";
    EXPECT_LT(prepared("intersection", "double").error.largest, 1e-14);
}

}  // namespace
}  // namespace relief::measure
