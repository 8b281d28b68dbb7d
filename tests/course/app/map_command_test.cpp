// relief map from the command line: maps as files, and what `relief inspect` says of them.
#include <cmath>

#include "framework/core/image/compare.h"
#include "framework/core/image/file.h"
#include "tests/course/app/course_copy.h"

namespace relief::app {
namespace {

class MapCommand : public testing::Test {
protected:
    TemporaryFolder folder_;
    const std::string assets_ = std::string(source_folder) + "/assets/";
    Result relief(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), relief_program());
        return run(arguments, {folder_.path(), {}});
    }
    /// Writes a height map of smooth hills that tiles.
    void hills(const std::string& name) const {
        Image image(64, 64, 1, 16);
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x) {
                const double u = x * 0.0981747704, v = y * 0.0981747704;  // 2 pi / 64
                *image.pixel(x, y) = float(0.5 + 0.2 * std::sin(u + 2 * v) + 0.15 * std::sin(3 * u - v + 1) +
                                           0.1 * std::cos(5 * u + 3 * v));
            }
        write_image(folder_.path() / name, image);
    }
    Image made(const std::string& name) const { return read_image(folder_.path() / name); }
};

TEST_F(MapCommand, MakesTheNormalMapOfAPlaneThatRises) {
    // A slope of 1/64 of the map's width per texel, at a depth of 1/2: 1/2 along u.
    Image ramp(64, 8, 1, 16);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 64; ++x) *ramp.pixel(x, y) = float(x) / 64;
    write_image(folder_.path() / "ramp.png", ramp);
    const Result result = relief({"map", "normal", "ramp.png", "-o", "normal.exr", "--depth", "0.5", "--no-wrap"});
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.out, "normal.exr: 64 x 8, green up, slopes 0.5 on average and 0.5 at most, 32-bit floats\n");
    const Image normals = made("normal.exr");
    const double z = 1 / std::sqrt(1.25);
    for (size_t i = 0; i < normals.values.size(); i += 3) {
        EXPECT_NEAR(normals.values[i], 0.5 - 0.25 * z, 2e-4);
        EXPECT_NEAR(normals.values[i + 1], 0.5, 1e-6);
        EXPECT_NEAR(normals.values[i + 2], 0.5 + 0.5 * z, 2e-4);
    }
}

TEST_F(MapCommand, InspectAgreesWithTheNormalMapThatItMakes) {
    hills("hills.png");
    for (const char* green : {"up", "down"}) {
        ASSERT_EQ(relief({"map", "normal", "hills.png", "-o", "n.png", "--green", green}).code, 0);
        const Result judged = relief({"inspect", "n.png", "hills.png"});
        EXPECT_EQ(judged.code, green == std::string("up") ? 0 : 1) << judged.out;
        EXPECT_EQ(contains(judged.out, "green      down"), green == std::string("down")) << judged.out;
    }
    EXPECT_EQ(made("n.png").bits, 8);
    ASSERT_EQ(relief({"map", "normal", "hills.png", "-o", "n.png", "--bits", "16"}).code, 0);
    EXPECT_EQ(made("n.png").bits, 16);
}

TEST_F(MapCommand, HeightsKeepAGreyPictureAndOcclusionIsLeastInValleys) {
    hills("hills.png");
    ASSERT_EQ(relief({"map", "heights", "hills.png", "-o", "h.png"}).code, 0);
    EXPECT_LE(difference(made("h.png"), made("hills.png"), 1).largest, 1e-4);
    const Result result = relief({"map", "occlusion", "h.png", "-o", "open.png", "--slices", "4", "--depth", "0.2"});
    ASSERT_EQ(result.code, 0);
    const Image open = made("open.png"), heights = made("h.png");
    double mean = 0;
    for (const float value : open.values) mean += double(value) / double(open.values.size());
    const size_t percent = result.out.find(", ");
    ASSERT_NE(percent, std::string::npos);
    EXPECT_NEAR(std::strtod(result.out.c_str() + percent + 2, nullptr), 100 * mean, 0.5) << result.out;
    double low = 0, lows = 0, high = 0, highs = 0;
    for (size_t i = 0; i < open.values.size(); ++i) {
        const double share = heights.values[i] > 0.5f ? 1 : 0;
        high += share * double(open.values[i]), highs += share;
        low += (1 - share) * double(open.values[i]), lows += 1 - share;
    }
    EXPECT_GT(high / highs, low / lows + 0.02);
}

TEST_F(MapCommand, CombineTakesChannelsOfFilesAndNumbers) {
    Image two(2, 1, 3, 8);
    two.values = {0, 0.2f, 0.4f, 0.6f, 0.8f, 1};
    write_image(folder_.path() / "rgb.png", two);
    const Result result = relief({"map", "combine", "rgb.png:b", "rgb.png", "1", "rgb.png:g", "-o", "packed.png"});
    EXPECT_EQ(result.out, "packed.png: 2 x 1, 4 channels, 8 bits\n") << result.err;
    const std::vector<float> wanted = {0.4f, 0, 1, 0.2f, 1, 0.6f, 1, 0.8f};
    const Image packed = made("packed.png");
    ASSERT_EQ(packed.values.size(), wanted.size());
    for (size_t i = 0; i < wanted.size(); ++i) EXPECT_NEAR(packed.values[i], wanted[i], 1e-6) << i;
}

TEST_F(MapCommand, WrongUseAndBrokenFilesAreOneLineAndWriteNothing) {
    folder_.write("text.png", "not a picture");
    hills("hills.png");
    const std::string heights = assets_ + "paving_height.png", albedo = assets_ + "bricks_albedo.png";
    const struct {
        std::vector<std::string> arguments;
        int code;
        const char* words;
    } cases[] = {{{"map", "normals", heights, "-o", "o.png"}, 2, "did you mean 'normal'?"},
                 {{"map", "normal", heights}, 2, "map needs -o FILE"},
                 {{"map", "normal", "-o", "o.png"}, 2, "map normal takes one FILE"},
                 {{"map", "normal", heights, heights, "-o", "o.png"}, 2, "map normal takes one FILE"},
                 {{"map", "normal", heights, "-o", "o.jpg"}, 2, "o.jpg"},
                 {{"map", "normal", heights, "-o", "o.png", "--filter", "sobol"}, 2, "did you mean 'sobel'?"},
                 {{"map", "normal", heights, "-o", "o.png", "--depth", "deep"}, 2, "--depth deep: a number from 0 to"},
                 {{"map", "normal", heights, "-o", "o.png", "--depth", "nan"}, 2, "--depth nan: a number from 0 to"},
                 {{"map", "normal", albedo, "-o", "o.png"}, 1, "bricks_albedo.png: has colours"},
                 {{"map", "normal", "text.png", "-o", "o.png"}, 1, "text.png: "},
                 {{"map", "normal", "missing.png", "-o", "o.png"}, 1, "missing.png: cannot read"},
                 {{"map", "combine", heights, "hills.png", "-o", "o.png"}, 1, "do not fit together"},
                 {{"map", "combine", heights + ":g", "-o", "o.png"}, 2, "has 1 channel"},
                 {{"map", "combine", "1", "-o", "o.png"}, 2, "a file for one channel at least"},
                 {{"map", "combine", "2", "-o", "o.png"}, 2, "0 to 1"},
                 {{"map", "normal", heights, "-o", "/proc/o.png"}, 1, "/proc/o.png"}};
    for (const auto& [arguments, code, words] : cases) {
        const Result result = relief(arguments);
        EXPECT_EQ(result.code, code) << words << "\n" << result.err;
        EXPECT_TRUE(contains(result.err, words)) << result.err;
        EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
        EXPECT_FALSE(std::filesystem::exists(folder_.path() / "o.png")) << words;
    }
}

}  // namespace
}  // namespace relief::app
