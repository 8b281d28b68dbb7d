// relief map from the command line: maps as files, and the findings of `relief inspect`.
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <glm/glm.hpp>
#include <set>
#include <thread>
#include <tuple>

#include "framework/core/base/text.h"
#include "framework/core/image/compare.h"
#include "framework/core/image/file.h"
#include "framework/staff/reference/degrees.h"
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
    /// Writes a square of 2 x 2 in the plane z = 0, with (cells + 1)² vertices at heights `height(u, v)`. Without
    /// normals: readers compute them from the faces.
    template <class Height>
    void square(const std::string& name, int cells, const Height& height, bool has_uv = true,
                const glm::dvec3& at = {}) const {
        std::string text;
        for (int j = 0; j <= cells; ++j)
            for (int i = 0; i <= cells; ++i) {
                const double u = double(i) / cells, v = double(j) / cells;
                text += fmt::format("v {} {} {}\nvt {} {}\n", at.x + 2 * u - 1, at.y + 2 * v - 1, at.z + height(u, v),
                                    u, v);
            }
        for (int j = 0; j < cells; ++j)
            for (int i = 0; i < cells; ++i) {
                const int a = j * (cells + 1) + i + 1, d = a + cells + 1;
                text += has_uv ? fmt::format("f {0}/{0} {1}/{1} {2}/{2} {3}/{3}\n", a, a + 1, d + 1, d)
                               : fmt::format("f {} {} {} {}\n", a, a + 1, d + 1, d);
            }
        folder_.write(name, text);
    }
    /// Writes fine.obj, smooth hills that tile, and coarse.obj, a flat square below and above them.
    void models() const {
        square("fine.obj", 96, [](double u, double v) {
            const double turn = 6.283185307179586;
            return 0.05 * std::sin(turn * (u + v)) + 0.03 * std::cos(turn * (2 * u - v) + 1);
        });
        square("coarse.obj", 1, [](double, double) { return 0.0; });
    }
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

TEST_F(MapCommand, GlossIsTheLuminanceOfLinearLightOrTheRestOfIt) {
    Image colors(4, 1, 3, 8);
    colors.values = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0.4f, 0.4f, 0.4f};
    write_image(folder_.path() / "colors.png", colors);
    const double grey = std::pow((0.4 + 0.055) / 1.055, 2.4);
    const std::vector<double> exact = {0.2126, 0.7152, 0.0722, grey};
    for (const bool inverted : {false, true}) {
        std::vector<std::string> arguments = {"map", "gloss", "colors.png", "-o", "gloss.exr"};
        if (inverted) arguments.emplace_back("--invert");
        const Result result = relief(arguments);
        EXPECT_EQ(result.out,
                  fmt::format("gloss.exr: 4 x 1, gloss from {}, a guess from {} places, 32-bit floats\n",
                              inverted ? "0.285 to 0.928" : "0.0722 to 0.715", inverted ? "dark" : "bright"))
            << result.err;
        const Image gloss = made("gloss.exr");
        ASSERT_EQ(gloss.channels, 1);
        for (size_t i = 0; i < 4; ++i) EXPECT_NEAR(gloss.values[i], inverted ? 1 - exact[i] : exact[i], 1e-5) << i;
    }
    colors.bits = 32;
    write_image(folder_.path() / "light.exr", colors);
    ASSERT_EQ(relief({"map", "gloss", "light.exr", "-o", "gloss.png", "--bits", "16"}).code, 0);
    EXPECT_NEAR(made("gloss.png").values[3], 0.4, 1e-4) << "floats are light already";
    EXPECT_TRUE(contains(relief({"inspect", "gloss.png"}).out, "kind")) << "a map of one channel";
}

TEST_F(MapCommand, InspectReadsTheBc5MapThatItMakesAsTheSameNormals) {
    hills("hills.png");
    ASSERT_EQ(relief({"map", "normal", "hills.png", "-o", "n.png", "--bits", "16"}).code, 0);
    for (const bool is_signed : {false, true}) {
        std::vector<std::string> arguments = {"map", "bc5", "n.png", "-o", "n.dds"};
        if (is_signed) arguments.emplace_back("--signed");
        const Result result = relief(arguments);
        ASSERT_EQ(result.code, 0) << result.err;
        // "n.dds: 64 x 64, BC5_UNORM, 1 level, M degrees off on average and L at most, 1 byte per texel"
        EXPECT_TRUE(
            result.out.starts_with(fmt::format("n.dds: 64 x 64, BC5_{}, 1 level, ", is_signed ? "SNORM" : "UNORM")))
            << result.out;
        EXPECT_TRUE(result.out.ends_with(", 1 byte per texel\n")) << result.out;
        EXPECT_EQ(read_all(folder_.path() / "n.dds")[128], char(is_signed ? 84 : 83)) << "DXGI_FORMAT";
        const Image decoded = made("n.dds"), normals = made("n.png");
        double sum = 0, largest = 0;
        for (size_t i = 0; i < normals.values.size(); i += 3) {
            const auto vector = [&](const Image& of) {
                return glm::normalize(2.0 * glm::dvec3(of.values[i], of.values[i + 1], of.values[i + 2]) - 1.0);
            };
            const glm::dvec3 a = vector(normals), b = vector(decoded);
            const double degrees = degrees_between(a, b);
            sum += degrees, largest = std::max(largest, degrees);
        }
        EXPECT_TRUE(contains(result.out, rounded(sum / 4096) + " degrees off on average and " + rounded(largest)))
            << result.out << sum / 4096 << " " << largest;
        const Result judged = relief({"inspect", "n.dds", "hills.png"});
        EXPECT_EQ(judged.code, 0) << judged.out;
        EXPECT_TRUE(contains(judged.out, "normals")) << judged.out;
    }
    const Result mips = relief({"map", "bc5", "n.png", "-o", "n.dds", "--mips"});
    EXPECT_TRUE(contains(mips.out, "7 levels")) << mips.out;
    EXPECT_TRUE(contains(mips.out, "1.34 bytes per texel"))
        << mips.out << "(1024 + 256 + ... + 16 + 16) / 4096 and more";
}

TEST_F(MapCommand, InspectAgreesWithTheMapsThatItBakes) {
    models();
    const Result normals = relief({"map", "bake", "fine.obj", "coarse.obj", "-o", "n.png", "--size", "64"});
    ASSERT_EQ(normals.code, 0) << normals.err;
    EXPECT_TRUE(
        normals.out.starts_with("n.png: 64 x 64, green up, texels: 4096 hit, 0 missed, 0 filled, largest distance "))
        << normals.out;
    EXPECT_TRUE(normals.out.ends_with(" of 0.141, 8 bits\n")) << normals.out << "2 sqrt(2) / 20";
    ASSERT_EQ(
        relief({"map", "bake", "fine.obj", "coarse.obj", "-o", "h.png", "--size", "64", "--store", "heights"}).code, 0);
    EXPECT_EQ(made("h.png").bits, 16);
    const Result judged = relief({"inspect", "n.png", "h.png"});
    EXPECT_EQ(judged.code, 0) << judged.out;
    // Heights from -0.08 to 0.08 on a square that is 2 wide and has 64 texels.
    EXPECT_TRUE(contains(judged.out, "a height of 1 is 5.12 texels")) << judged.out;
    ASSERT_EQ(relief({"map", "bake", "fine.obj", "coarse.obj", "-o", "n.png", "--size", "64", "--green", "down"}).code,
              0);
    const Result down = relief({"inspect", "n.png", "h.png"});
    EXPECT_EQ(down.code, 1);
    EXPECT_TRUE(contains(down.out, "green      down")) << down.out;
}

TEST_F(MapCommand, BakesTheExactNormalsAndHeightsOfHills) {
    models();
    ASSERT_EQ(relief({"map", "bake", "fine.obj", "coarse.obj", "-o", "n.exr", "--size", "48x32"}).code, 0);
    const Result result =
        relief({"map", "bake", "fine.obj", "coarse.obj", "-o", "h.exr", "--size", "48x32", "--store", "heights"});
    ASSERT_EQ(result.code, 0) << result.err;
    const Image normals = made("n.exr"), heights = made("h.exr");
    ASSERT_EQ(normals.width, 48);
    ASSERT_EQ(normals.height, 32);
    const double turn = 6.283185307179586;
    double worst = 0, low = 1, high = -1;
    std::vector<double> exact_heights;
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 48; ++x) {
            const double u = (x + 0.5) / 48, v = 1 - (y + 0.5) / 32, a = turn * (u + v), b = turn * (2 * u - v) + 1;
            exact_heights.push_back(0.05 * std::sin(a) + 0.03 * std::cos(b));
            low = std::min(low, exact_heights.back()), high = std::max(high, exact_heights.back());
            // Slopes along x and y, of which 2 are 1 of u and v.
            const double slope_x = turn / 2 * (0.05 * std::cos(a) - 0.06 * std::sin(b));
            const double slope_y = turn / 2 * (0.05 * std::cos(a) + 0.03 * std::sin(b));
            const glm::dvec3 exact = glm::normalize(glm::dvec3(-slope_x, -slope_y, 1));
            const float* const texel = normals.pixel(x, y);
            const glm::dvec3 baked = 2.0 * glm::dvec3(texel[0], texel[1], texel[2]) - 1.0;
            // At the border, a vertex has half of its faces.
            if (x > 0 && y > 0 && x < 47 && y < 31) worst = std::max(worst, degrees_between(baked, exact));
        }
    EXPECT_LT(worst, 0.3) << "degrees; the hills have 96 cells along a side";
    const size_t from = result.out.find("heights from "), to = result.out.find(" to ", from);
    ASSERT_NE(to, std::string::npos) << result.out;
    EXPECT_NEAR(std::strtod(result.out.c_str() + from + 13, nullptr), low, 2e-4) << result.out;
    EXPECT_NEAR(std::strtod(result.out.c_str() + to + 4, nullptr), high, 2e-4) << result.out;
    for (size_t i = 0; i < exact_heights.size(); ++i)
        EXPECT_NEAR(heights.values[i], (exact_heights[i] - low) / (high - low), 3e-3) << i;
}

TEST_F(MapCommand, ObjectSpaceIsWhatInspectCallsIt) {
    // A box of which every face has its own part of the map: its normals point in all six directions.
    std::string box = "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n";
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 3; ++i)
            for (const auto& [u, v] : {std::pair(0.02, 0.02), {0.3, 0.02}, {0.3, 0.45}, {0.02, 0.45}})
                box += fmt::format("vt {} {}\n", i / 3.0 + u, j / 2.0 + v);
    const char* const faces[] = {"4 3 2 1", "5 6 7 8", "1 2 6 5", "3 4 8 7", "2 3 7 6", "4 1 5 8"};
    for (int face = 0; face < 6; ++face) {
        int a, b, c, d;
        ASSERT_EQ(std::sscanf(faces[face], "%d %d %d %d", &a, &b, &c, &d), 4);
        const int uv = 4 * face + 1;
        box += fmt::format("s off\nf {}/{} {}/{} {}/{} {}/{}\n", a, uv, b, uv + 1, c, uv + 2, d, uv + 3);
    }
    folder_.write("box.obj", box);
    const Result result =
        relief({"map", "bake", "box.obj", "box.obj", "-o", "o.png", "--size", "96x64", "--store", "object"});
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_TRUE(contains(result.out, "object space")) << result.out;
    EXPECT_TRUE(contains(result.out, " 0 missed")) << result.out;
    EXPECT_TRUE(contains(result.out, "largest distance 0 of")) << result.out;
    EXPECT_TRUE(contains(relief({"inspect", "o.png"}).out, "object")) << relief({"inspect", "o.png"}).out;
    ASSERT_EQ(relief({"map", "bake", "box.obj", "box.obj", "-o", "t.png", "--size", "96x64"}).code, 0);
    const Image tangent = made("t.png");
    for (size_t i = 0; i < tangent.values.size(); i += 3) EXPECT_EQ(tangent.values[i + 2], 1) << "flat everywhere";
}

TEST_F(MapCommand, BakesModelsFarFromTheOriginByOneCentre) {
    const auto wave = [](double u, double v) {
        const double turn = 6.283185307179586;
        return 0.05 * std::sin(turn * (u + v)) + 0.03 * std::cos(turn * (2 * u - v) + 1);
    };
    const auto flat = [](double, double) { return 0.0; };
    const glm::dvec3 far(432100, 250, 5412300);
    square("fine.obj", 48, wave), square("coarse.obj", 1, flat);
    square("far_fine.obj", 48, wave, true, far), square("far_coarse.obj", 1, flat, true, far);
    for (const auto& [fine, coarse, to] :
         {std::array{"fine.obj", "coarse.obj", "near.exr"}, std::array{"far_fine.obj", "far_coarse.obj", "far.exr"}}) {
        const Result result = relief({"map", "bake", fine, coarse, "-o", to, "--size", "64"});
        ASSERT_EQ(result.code, 0) << result.err;
        EXPECT_TRUE(contains(result.out, "4096 hit, 0 missed")) << result.out;
    }
    const Image near = made("near.exr"), away = made("far.exr");
    for (size_t i = 0; i < near.values.size(); ++i)  // a digit of 1e-9 m in the file, over 0.04 m between vertices
        ASSERT_NEAR(near.values[i], away.values[i], 2e-5) << i;
}

TEST_F(MapCommand, AFaceWithoutUvIsNamedWithItsLine) {
    models();
    folder_.write("part.obj",
                  "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\nf 1 3 4\n");
    const Result result = relief({"map", "bake", "fine.obj", "part.obj", "-o", "o.png"});
    EXPECT_EQ(result.code, 1);
    EXPECT_TRUE(contains(result.err, "part.obj:9: this face has corners without uv (vt)")) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
}

TEST_F(MapCommand, AllCommandsReadTheSameHeights) {
    // Metres with a mark of missing data and a NaN, beside the same heights from 0 to 1.
    hills("plain.exr");
    Image plain = made("plain.exr");
    const auto [low, high] = std::minmax_element(plain.values.begin(), plain.values.end());
    const float least = *low, most = *high;
    for (float& value : plain.values) value = (value - least) / (most - least);
    Image metres = plain;
    for (float& value : metres.values) value = 1000 + 512 * value;
    plain.bits = 32;
    write_image(folder_.path() / "plain.exr", plain), write_image(folder_.path() / "metres.exr", metres);
    metres.values[700] = -9999, metres.values[900] = NAN;
    write_image(folder_.path() / "holes.exr", metres);
    const auto picture = [&](const std::string& map) {
        const Result shot =
            relief({"shot", "12", "--set", "view=one", "--set", "map=" + map, "--size", "320x240", "-o", "shot.exr"});
        const Result normal = relief({"map", "normal", map, "-o", "normal.exr"});
        EXPECT_EQ(shot.code + normal.code, 0) << shot.err << normal.err;
        EXPECT_EQ(shot.err, normal.err) << "one rule, one note";
        // Notes about the map cover at most the lower half.
        const Image whole = made("shot.exr");
        Image upper(whole.width, whole.height / 2, whole.channels);
        upper.values.assign(whole.values.begin(), whole.values.begin() + std::ptrdiff_t(upper.values.size()));
        return std::tuple(upper, made("normal.exr"), shot.err, relief({"inspect", map}).out);
    };
    const auto [shot, normal, note, words] = picture("plain.exr");
    EXPECT_EQ(note, "");
    const auto [shot_m, normal_m, note_m, words_m] = picture("metres.exr");
    EXPECT_EQ(note_m, "relief: metres.exr: heights from 1000 to 1512 are scaled to 0 to 1\n");
    EXPECT_LT(difference(normal, normal_m, 0).largest, 1e-3);
    EXPECT_LT(difference(shot, shot_m, 0.02).pixels_over, 20u);
    const auto [shot_h, normal_h, note_h, words_h] = picture("holes.exr");
    EXPECT_TRUE(contains(note_h, "1 texel holds NaN or infinity") && contains(note_h, "1 texel holds -9999")) << note_h;
    EXPECT_TRUE(contains(words_h, "1 texel holds -9999") && contains(words_h, "1000 to 1512")) << words_h;
    EXPECT_LT(difference(shot, shot_h, 0.02).pixels_over, 100u) << "around two texels";
}

TEST_F(MapCommand, RefusesOptionsThatTheKindDoesNotUse) {
    const std::pair<const char*, std::set<std::string>> options[] = {
        {"--depth=0.1", {"normal", "occlusion"}},
        {"--filter=sobel", {"normal"}},
        {"--green=down", {"normal", "bake"}},
        {"--no-wrap", {"normal"}},
        {"--slices=4", {"occlusion"}},
        {"--invert", {"gloss"}},
        {"--signed", {"bc5"}},
        {"--mips", {"bc5"}},
        {"--best", {"bc5"}},
        {"--store=object", {"bake"}},
        {"--size=8", {"bake"}},
        {"--reach=1", {"bake"}},
        {"--bits=8", {"normal", "heights", "occlusion", "gloss", "combine", "bake"}}};
    for (const std::string kind : {"normal", "heights", "occlusion", "gloss", "combine", "bc5", "bake"})
        for (const auto& [option, kinds] : options) {
            const auto words = split(option, '=');
            std::vector<std::string> arguments = {"map",     kind,      "missing",
                                                  "missing", "missing", "missing",
                                                  "missing", "-o",      kind == "bc5" ? "o.dds" : "o.png"};
            arguments.insert(arguments.end(), words.begin(), words.end());
            const Result result = relief(arguments);
            EXPECT_EQ(result.code, 2) << kind << " " << option;
            const std::string refusal = fmt::format("map {} does not use {}, which is for ", kind, words[0]);
            EXPECT_EQ(contains(result.err, refusal), !kinds.contains(kind)) << result.err;
            for (const std::string& user : kinds)
                EXPECT_TRUE(kinds.contains(kind) || contains(result.err, user)) << result.err;
            EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
        }
}

TEST_F(MapCommand, LeavesNoFileWhenItIsInterrupted) {
    models();
    Process process({relief_program(), "map", "bake", "fine.obj", "coarse.obj", "-o", "o.png", "--size", "8192"},
                    {folder_.path(), {}});
    std::this_thread::sleep_for(std::chrono::milliseconds(800));
    ASSERT_TRUE(process.running()) << "it was too fast to interrupt";
    process.signal(SIGINT);
    EXPECT_EQ(process.wait().code, 128 + SIGINT);
    std::vector<std::string> files = files_in(folder_.path());
    std::sort(files.begin(), files.end());
    EXPECT_EQ(files, (std::vector<std::string>{"coarse.obj", "fine.obj"}));
}

TEST_F(MapCommand, WrongUseAndBrokenFilesAreOneLineAndWriteNothing) {
    folder_.write("text.png", "not a picture");
    hills("hills.png");
    models();
    square(
        "plain.obj", 1, [](double, double) { return 0.0; }, false);
    square("away.obj", 1, [](double, double) { return 9.0; });
    folder_.write("broken.obj", "v 0 0 0\nv 1 0 zero\nf 1 2 3\n");
    const std::string heights = assets_ + "paving_height.png", albedo = assets_ + "bricks_albedo.png";
    expect_refused(
        [&](const auto& words) { return relief(words); },
        {{{"map", "normals", heights, "-o", "o.png"}, "did you mean 'normal'?"},
         {{"map", "normal", heights}, "map needs -o FILE"},
         {{"map", "normal", "-o", "o.png"}, "map normal takes one FILE"},
         {{"map", "normal", heights, heights, "-o", "o.png"}, "map normal takes one FILE"},
         {{"map", "normal", heights, "-o", "o.jpg"}, "o.jpg"},
         {{"map", "normal", heights, "-o", "o.png", "--filter", "sobol"}, "did you mean 'sobel'?"},
         {{"map", "normal", heights, "-o", "o.png", "--depth", "deep"}, "--depth deep: a number from 0 to"},
         {{"map", "normal", heights, "-o", "o.png", "--depth", "nan"}, "--depth nan: a number from 0 to"},
         {{"map", "normal", albedo, "-o", "o.png"}, "bricks_albedo.png: shows colours", 1},
         {{"map", "normal", "text.png", "-o", "o.png"}, "text.png: ", 1},
         {{"map", "normal", "missing.png", "-o", "o.png"}, "missing.png: cannot read", 1},
         {{"map", "combine", heights, "hills.png", "-o", "o.png"}, "do not fit together", 1},
         {{"map", "combine", heights + ":g", "-o", "o.png"}, "has 1 channel"},
         {{"map", "combine", "1", "-o", "o.png"}, "a file for one channel at least"},
         {{"map", "combine", "2", "-o", "o.png"}, "0 to 1"},
         {{"map", "normal", heights, "-o", "o.exr", "--bits", "8"}, "--bits is for PNG files"},
         {{"map", "bc5", albedo, "-o", "o.png"}, "'o.png' must end in .dds"},
         {{"map", "bc5", albedo, "-o", "o.dds"}, "bricks_albedo.png: ", 1},
         {{"map", "bc5", heights, "-o", "o.dds"}, "paving_height.png: is grey", 1},
         {{"map", "bake", "fine.obj", "-o", "o.png"}, "map bake takes FINE.obj and COARSE.obj"},
         {{"map", "bake", "fine.obj", "broken.obj", "-o", "o.png"}, "broken.obj:2: ", 1},
         {{"map", "bake", "broken.obj", "coarse.obj", "-o", "o.png"}, "broken.obj:2: ", 1},
         {{"map", "bake", "fine.obj", "missing.obj", "-o", "o.png"}, "missing.obj: cannot read", 1},
         {{"map", "bake", "fine.obj", "plain.obj", "-o", "o.png"}, "plain.obj: has no uv", 1},
         {{"map", "bake", "away.obj", "coarse.obj", "-o", "o.png"}, "away.obj: no ray from coarse.obj meets", 1},
         {{"map", "bake", "fine.obj", "coarse.obj", "-o", "o.png", "--size", "0"}, "--size takes"},
         {{"map", "bake", "fine.obj", "coarse.obj", "-o", "o.png", "--reach", "-1"}, "--reach -1: a number"},
         {{"map", "bake", "fine.obj", "coarse.obj", "-o", "o.png", "--store", "objekt"}, "'object'?"},
         {{"map", "bake", "fine.obj", "coarse.obj", "-o", "o.png", "--store", "object", "--green", "up"},
          "--store object does not use --green"},
         {{"map", "normal", heights, "-o", "/proc/o.png"}, "/proc/o.png", 1}});
    for (const char* name : {"o.png", "o.exr", "o.dds"})
        EXPECT_FALSE(std::filesystem::exists(folder_.path() / name)) << name;
}

}  // namespace
}  // namespace relief::app
