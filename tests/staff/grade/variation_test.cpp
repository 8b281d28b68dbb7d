// Hidden views, and the parts in which a class is graded.
#include "framework/staff/grade/variation.h"

#include <cmath>

#include "framework/core/base/error.h"
#include "framework/staff/class/roster.h"
#include "framework/staff/grade/check_views.h"
#include "tests/support.h"

namespace relief::grade {
namespace {

Manifest varied() {
    Manifest manifest = parse_manifest("title = \"x\"\n", "lab.toml");
    add_grading(manifest, "[vary]\nlight_yaw = [-60, 60]\nmap = [\"a\", \"b\", \"c\"]\npicture_size = [0.75, 0.95]\n",
                "grading.toml");
    return manifest;
}

TEST(Slowness, IsReportedAboveTwentyTimesTheSolutionsTime) {
    EXPECT_EQ(slowness(2.0, 0.1), "");
    EXPECT_EQ(slowness(6.9, 0.2), "it takes 34 times the processor time of the solution, 6.9 seconds");
    EXPECT_EQ(slowness(0.9, 0.001), "") << "the first picture of a process may take so long";
    EXPECT_EQ(slowness(std::nan(""), 0.001), "") << "a program may say anything";
}

TEST(Variation, IsDecidedBySeedLabAndAttemptAlone) {
    const Manifest manifest = varied();
    const auto view = [&](const char* lab, const char* seed, int attempt) {
        return view_text(Variation(manifest, lab, seed, attempt).vary({}));
    };
    EXPECT_EQ(view("01", "x", 0), view("01", "x", 0));
    std::set<std::string> all = {view("01", "x", 0), view("02", "x", 0), view("01", "y", 0), view("01", "x", 1)};
    EXPECT_EQ(all.size(), 4u);
}

TEST(Variation, StaysInItsRangesAndIsNeverTheKnownView) {
    const Manifest manifest = varied();
    std::set<std::string> maps;
    const Shot known;
    for (int i = 0; i < 200; ++i) {
        const Shot shot = Variation(manifest, "01", std::to_string(i), 0).vary(known);
        const double yaw = std::abs(shot.camera.yaw - known.camera.yaw);
        EXPECT_TRUE(yaw >= 5.9 && yaw <= 20.1) << yaw;
        EXPECT_TRUE(std::abs(shot.camera.distance / known.camera.distance - 1) <= 0.151);
        for (const int axis : {0, 1}) {
            EXPECT_LT(shot.size[axis], known.size[axis]);
            EXPECT_GE(shot.size[axis], 0.74 * known.size[axis]);
        }
        ASSERT_EQ(shot.set.size(), 2u);
        EXPECT_LE(std::abs(std::stod(shot.set[0].second)), 60);
        maps.insert(shot.set[1].second);
    }
    EXPECT_EQ(maps, (std::set<std::string>{"a", "b", "c"}));
}

TEST(Variation, KeepsTheKnobsThatACheckSets) {
    Shot shot;
    shot.set = {{"map", "posts"}};
    const Shot hidden = Variation(varied(), "01", "x", 0).vary(shot);
    EXPECT_EQ(hidden.set[0], (std::pair<std::string, std::string>{"map", "posts"}));
    EXPECT_EQ(hidden.set.size(), 2u);
}

TEST(Shard, IsReadFromTheOptionOrTheJobArrayVariables) {
    const auto parts = [](const std::string& text) {
        const Shard shard = shard_of(text);
        return std::pair{shard.index, shard.count};
    };
    EXPECT_TRUE(shard_of("").whole());
    EXPECT_EQ(parts("2/8"), (std::pair{1, 8}));
    for (const char* wrong : {"0/8", "9/8", "8", "1/0", "a/b", "1/", "/3", "1/2/3"})
        EXPECT_THROW(shard_of(wrong), UsageError) << wrong;
    for (const std::string prefix : {"TEST", "GTEST"}) {
        const Environment sharded({{prefix + "_SHARD_INDEX", "3"}, {prefix + "_TOTAL_SHARDS", "4"}});
        EXPECT_EQ(parts(""), (std::pair{3, 4}));
    }
    const Environment broken({{"TEST_SHARD_INDEX", "4"}, {"TEST_TOTAL_SHARDS", "4"}});
    EXPECT_THROW(shard_of(""), UsageError);
}

TEST(Roster, RoundTripsThroughItsFile) {
    const TemporaryFolder folder;
    EXPECT_FALSE(read_roster(folder.path()));
    const Roster roster{
        "c",
        "s\xff",
        {"01_x"},
        {{"o'd \"d\"\n", "h", {{"/a/b"}}, {"a remark"}}, {"jane", "", {{"/c", "task.glsl", 7}, {"/m\xfc"}}}},
        {"/a", "/m\xfc"}};
    write_roster(folder.path(), roster);
    const auto read = read_roster(folder.path());
    ASSERT_TRUE(read);
    EXPECT_EQ(read->course + read->seed, "cs\xff") << "a seed of any bytes";
    EXPECT_EQ(read->labs, roster.labs);
    EXPECT_EQ(read->submissions, roster.submissions);
    EXPECT_EQ(read->given, roster.given);
    folder.write("class.json", "{\"schema\": 1");
    EXPECT_THROW(read_roster(folder.path()), Error);
}

}  // namespace
}  // namespace relief::grade
