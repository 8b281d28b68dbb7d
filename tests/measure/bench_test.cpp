// The harness of relief bench: figures, turns, and what it writes.
#include "framework/measure/bench.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "framework/base/text.h"
#include "tests/support.h"

namespace relief {
namespace {

TEST(Quantile, LiesBetweenTwoValuesInProportion) {
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

/// A clock that moves only when a method runs.
struct Machine {
    double now = 0;
    std::vector<std::string> ran;
    BenchMethod method(const std::string& name, double seconds) {
        return {.name = name, .knobs = {}, .items = 10, .run = [this, name, seconds] {
                    now += seconds, ran.push_back(name);
                }};
    }
    std::vector<BenchTimes> time(std::vector<BenchMethod> methods, int repeats) {
        return time_in_turns(methods, repeats, [this] { return now; });
    }
};

TEST(TimeInTurns, GivesNanosecondsAnItem) {
    Machine machine;
    const auto times = machine.time({machine.method("slow", 0.5), machine.method("quick", 0.01)}, 3);
    EXPECT_NEAR(times[0].median, 0.5e9 / 10, 1);
    EXPECT_NEAR(times[1].median, 0.01e9 / 10, 1);
    EXPECT_NEAR(times[0].p10, times[0].p90, 1);
}

TEST(TimeInTurns, RunsAllMethodsInEachRoundInChangingOrder) {
    Machine machine;
    machine.time({machine.method("a", 1), machine.method("b", 1), machine.method("c", 1)}, 8);
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

TEST(TimeInTurns, RepeatsWhatIsShorterThanAMillisecond) {
    Machine machine;
    const auto times = machine.time({machine.method("short", 1e-5)}, 1);
    EXPECT_GE(machine.ran.size(), 100u);
    EXPECT_NEAR(times[0].median, 1e-5 * 1e9 / 10, 1e-3);
}

TEST(TimeInTurns, SeesADriftOfTheMachineInAllMethodsAlike) {
    // Each run takes a little longer than the one before: the medians stay within that drift of each other.
    Machine machine;
    double slower = 1;
    const auto drifting = [&](const char* name) {
        return BenchMethod{.name = name, .knobs = {}, .run = [&] { machine.now += slower, slower *= 1.01; }};
    };
    const auto times = machine.time({drifting("a"), drifting("b")}, 40);
    EXPECT_NEAR(times[0].median / times[1].median, 1, 0.03);
}

std::vector<std::string> fields(const std::string& line) {
    std::vector<std::string> result(1);
    bool inside = false;
    for (size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"' && inside && i + 1 < line.size() && line[i + 1] == '"')
            result.back() += line[++i];
        else if (line[i] == '"')
            inside = !inside;
        else if (line[i] == ',' && !inside)
            result.emplace_back();
        else
            result.back() += line[i];
    }
    return result;
}

TEST(BenchCsv, HasAFieldForEachColumnWhateverTheTextsHold) {
    const BenchTopic topic{"topic", "help", {}};
    const std::vector<BenchMethod> methods = {{.name = "plain, \"quoted\"",
                                               .knobs = {{"a", "1"}, {"b", "2"}},
                                               .items = 7,
                                               .item = "texel",
                                               .bytes_per_item = 16,
                                               .run = {},
                                               .error = {1, 2, 3, "degree"}},
                                              {.name = "peer", .knobs = {}, .run = {}}};
    const std::vector<BenchTimes> times = {{4, 3, 5}, {1, 1, 1}};
    const std::string csv = bench_csv(topic, methods, times, {.repeats = 9}, {"A, CPU", "gcc", "abc", "none"});
    std::vector<std::string> lines = split(csv, '\n');
    ASSERT_EQ(lines.size(), 4u) << "a header, two lines, and the end of the last";
    for (std::string& line : lines)
        if (line.ends_with('\r')) line.pop_back();
    const auto header = fields(lines[0]), first = fields(lines[1]), second = fields(lines[2]);
    ASSERT_EQ(first.size(), header.size());
    ASSERT_EQ(second.size(), header.size());
    const auto field = [&](const std::vector<std::string>& line, const char* name) {
        return line[size_t(std::find(header.begin(), header.end(), name) - header.begin())];
    };
    EXPECT_EQ(field(first, "method"), "plain, \"quoted\"");
    EXPECT_EQ(field(first, "knobs"), "a=1 b=2");
    EXPECT_EQ(field(first, "repeats"), "9");
    EXPECT_EQ(field(first, "ns_per_item_p90"), "5");
    EXPECT_EQ(field(first, "error_p99"), "2");
    EXPECT_EQ(field(first, "cpu"), "A, CPU");
    EXPECT_EQ(field(second, "error_mean"), "") << "a peer makes no claim";
    EXPECT_EQ(field(second, "bytes_per_item"), "");
}

TEST(BenchTable, ShowsEveryMethodWithItsFigures) {
    const BenchTopic topic{"topic", "what it is about", {}};
    const std::vector<BenchMethod> methods = {
        {.name = "one", .knobs = {{"threads", "2"}}, .item = "texel", .run = {}, .error = {0.125, 2, 3, "degree"}}};
    const std::string table = bench_table(topic, methods, std::vector<BenchTimes>{{4.5, 3, 5}});
    for (const char* part : {"what it is about", "one", "threads=2", "ns/texel", "4.5", "mean degree", "0.125"})
        EXPECT_TRUE(contains(table, part)) << part;
}

TEST(BenchTopics, AllMakeMethodsThatRunAndMeasureErrors) {
    for (const BenchTopic& topic : bench_topics()) {
        // There is no context here, and there are none of the course's labs: relief bench is run by the commands' test.
        if (topic.draws || topic.name == "grade" || topic.name == "start") continue;
        const auto methods = topic.methods({.repeats = 1, .quick = true});
        EXPECT_FALSE(methods.empty()) << topic.name;
        size_t with_error = 0;
        for (const BenchMethod& method : methods) {
            method.run();
            with_error += !method.error.unit.empty();
            EXPECT_TRUE(std::isfinite(method.error.largest)) << topic.name << " " << method.name;
            EXPECT_LE(method.error.mean, method.error.largest) << topic.name << " " << method.name;
            EXPECT_GT(method.items, 0u);
        }
        EXPECT_GT(with_error, 0u) << topic.name;
    }
}

}  // namespace
}  // namespace relief
