// Lab 02: each format against its codec in double precision, and against published errors.
#include <cmath>
#include <limits>

#include "framework/core/base/error.h"
#include "framework/core/base/parallel.h"
#include "framework/library/kit/labels.h"
#include "framework/library/maps/bc1.h"
#include "framework/staff/reference/degrees.h"
#include "framework/staff/reference/rgtc.h"
#include "labs/02_normal_map_storage/blocks.h"
#include "labs/02_normal_map_storage/maps.h"
#include "tests/labs/shots.h"

namespace relief {
namespace {

constexpr const char* formats[] = {"unorm8", "unorm8-truncated", "snorm8", "paired8", "rg8", "rg16", "oct16", "half"};
std::vector<Knob> one(const char* format) { return {{"view", "one"}, {"format", format}}; }

TEST(NormalMapStorage, EveryFormatMatchesDoublePrecision) {
    for (const char* format : formats) {
        const ErrorSummary off = error_of("02", shot_of("02", one(format), "stored"));
        EXPECT_GT(off.count, 4000u) << format;
        // A direction in single precision sometimes falls on the other side of a tie. With 16-bit codes this is more
        // frequent, because their steps are closer to the rounding of floats.
        EXPECT_LT(off.mean, std::string(format) == "rg16" ? 0.05 : 0.01) << format;
    }
}

/// Returns the mean error over the whole sphere, seen from six sides. Many pixels share a code, so that the pixel grid
/// does not align with the grid of codes.
double mean_error(std::vector<Knob> knobs) {
    double sum = 0;
    for (const auto& [yaw, pitch] : {std::pair(0, 0), {90, 0}, {180, 0}, {270, 0}, {0, 89}, {0, -89}}) {
        Shot shot = shot_of("02", knobs, "normal");
        shot.camera.yaw = yaw, shot.camera.pitch = pitch, shot.size = {331, 331};
        sum += error_of("02", shot).mean / 6;
    }
    return sum;
}

TEST(NormalMapStorage, TruncatingAndAMismatchedDecoderEachDoubleTheError) {
    EXPECT_NEAR(mean_error(one("unorm8")), 0.170, 0.003);  // Cigolle et al. 2014
    EXPECT_NEAR(mean_error(one("unorm8-truncated")), 0.339, 0.01);
    std::vector<Knob> mismatch = one("paired8");
    mismatch.emplace_back("mismatch", "on");
    EXPECT_NEAR(mean_error(mismatch), 0.340, 0.01);
    EXPECT_NEAR(mean_error(one("oct16")), 0.337, 0.01);  // Cigolle et al. 2014
}

TEST(NormalMapStorage, TwoChannelsShowNoSurfaceBelowTheHorizon) {
    Shot shot = shot_of("02", one("rg8"), "normal");
    shot.camera.yaw = 180, shot.camera.pitch = 60;
    const Image normal = drawn("02", shot);
    for (size_t i = 0; i < normal.pixel_count(); ++i)
        ASSERT_TRUE(normal.values[i * 4] == no_surface || normal.values[i * 4 + 2] >= 0);
}

using storage::compress, storage::BlockMap, storage::MapName, storage::normal_map;

RgtcKind kind_of(bool is_signed) { return is_signed ? RgtcKind::snorm : RgtcKind::unorm; }

std::array<uint8_t, 8> channel_bytes(const BlockMap& map, size_t channel) {
    std::array<uint8_t, 8> bytes;
    std::copy_n(map.bytes.begin() + ptrdiff_t(8 * channel), 8, bytes.begin());
    return bytes;
}

/// Returns the values of a channel of a block. Channel 2 i is x of block i, channel 2 i + 1 is y.
std::array<double, 16> channel_values(const Image& normals, bool is_signed, size_t channel) {
    const int columns = (normals.width + 3) / 4, block = int(channel / 2);
    std::array<double, 16> values;
    for (int i = 0; i < 16; ++i) {
        const int x = std::min(block % columns * 4 + i % 4, normals.width - 1);
        const int y = std::min(block / columns * 4 + i / 4, normals.height - 1);
        const double n = normals.pixel(x, normals.height - 1 - y)[channel % 2];
        values[size_t(i)] = is_signed ? n : 0.5 * n + 0.5;
    }
    return values;
}

struct Degrees {
    double mean = 0, largest = 0;
};

/// Returns the error of a map that was stored: `stored` has x and y, or three components if `has_z`.
Degrees error_in_degrees(const Image& normals, const Image& stored, bool has_z) {
    Degrees degrees;
    for (size_t i = 0; i < normals.pixel_count(); ++i) {
        const float *n = &normals.values[i * 3], *s = &stored.values[i * size_t(stored.channels)];
        const double z = has_z ? s[2] : std::sqrt(std::max(0.0, 1 - double(s[0]) * s[0] - double(s[1]) * s[1]));
        const glm::dvec3 exact(n[0], n[1], n[2]), read(s[0], s[1], z);
        const double error = degrees_between(exact, read);
        degrees.mean += error / double(normals.pixel_count());
        degrees.largest = std::max(degrees.largest, error);
    }
    return degrees;
}

/// Returns x and y of a map whose channels `encode` encodes, by the decoder of the specification.
template <class Encode>
Image through_blocks(const Image& normals, bool is_signed, Encode encode) {
    Image result(normals.width, normals.height, 2);
    parallel_each(normals.pixel_count() / 8, 0, [&](size_t channel) {
        const RgtcBlock block = encode(channel_values(normals, is_signed, channel), channel);
        const auto decoded = rgtc_decode(block, kind_of(is_signed));
        const int columns = normals.width / 4, index = int(channel / 2);
        for (int i = 0; i < 16; ++i) {
            const int x = index % columns * 4 + i % 4, y = index / columns * 4 + i / 4;
            result.pixel(x, normals.height - 1 - y)[channel % 2] =
                float(is_signed ? decoded[size_t(i)] : 2 * decoded[size_t(i)] - 1);
        }
    });
    return result;
}

/// Returns (n + 1) / 2 of each component, or the inverse of it.
Image as_colors(Image normals) {
    for (float& value : normals.values) value = 0.5f * value + 0.5f;
    return normals;
}
Image as_normals(Image colors) {
    for (float& value : colors.values) value = 2 * value - 1;
    return colors;
}
Image in_bytes(Image colors) {
    for (float& value : colors.values) value = std::round(255 * value) / 255;
    return colors;
}

TEST(NormalMapBlocks, TheSolutionIsRangeFit) {
    for (const MapName name : {MapName::shapes, MapName::bricks, MapName::paving})
        for (const bool is_signed : {false, true}) {
            const Image normals = normal_map(name);
            const BlockMap map = compress(normals, is_signed);
            ASSERT_EQ(map.bytes.size(), normals.pixel_count()) << "a byte a texel";
            for (size_t channel = 0; channel < map.bytes.size() / 8; ++channel) {
                const auto values = channel_values(normals, is_signed, channel);
                const RgtcBlock own = rgtc_block(channel_bytes(map, channel), kind_of(is_signed));
                const RgtcBlock fit = rgtc_range_fit(values, kind_of(is_signed));
                // Ties round either way.
                EXPECT_LE(std::abs(own.first - fit.first) + std::abs(own.second - fit.second), 1);
                EXPECT_NEAR(rgtc_squared_error(own, values, kind_of(is_signed)),
                            rgtc_squared_error(fit, values, kind_of(is_signed)), 1e-4);
            }
        }
}

TEST(NormalMapBlocks, HaveTheErrorsOfTheHandout) {
    struct Row {
        MapName map;
        Degrees two_bytes, bc1, bc5, best, of_signed, best_signed;
    };
    // Measured once; this test repeats it.
    for (const Row& row : {Row{MapName::shapes,
                               {0.2268, 0.370},
                               {3.2972, 16.313},
                               {0.9030, 6.062},
                               {0.6568, 5.444},
                               {0.8375, 5.871},
                               {0.6246, 5.107}},
                           Row{MapName::bricks,
                               {0.0542, 0.512},
                               {3.8026, 25.714},
                               {0.8556, 7.210},
                               {0.7216, 4.421},
                               {0.8659, 7.005},
                               {0.7311, 5.110}},
                           Row{MapName::paving,
                               {0.0270, 0.337},
                               {1.7555, 14.993},
                               {0.4030, 3.172},
                               {0.3047, 2.636},
                               {0.4323, 3.135},
                               {0.3472, 2.780}}}) {
        const Image normals = normal_map(row.map);
        const auto expect = [&](const char* format, const Degrees& expected, const Degrees& measured) {
            SCOPED_TRACE(fmt::format("{} {}: {:.4f}, {:.3f}", storage::map_names[size_t(row.map)], format,
                                     measured.mean, measured.largest));
            EXPECT_NEAR(measured.mean, expected.mean, 0.0001);
            EXPECT_NEAR(measured.largest, expected.largest, 0.001);
        };
        const auto blocks = [&](bool is_signed, bool is_best) {
            const BlockMap map = compress(normals, is_signed);
            const auto encode = [&](const auto& values, size_t channel) {
                return is_best ? rgtc_best(values, kind_of(is_signed))
                               : rgtc_block(channel_bytes(map, channel), kind_of(is_signed));
            };
            return error_in_degrees(normals, through_blocks(normals, is_signed, encode), false);
        };
        const Image colors = as_colors(normals);
        expect("8:8", row.two_bytes, error_in_degrees(normals, as_normals(in_bytes(colors)), false));
        expect("BC1", row.bc1, error_in_degrees(normals, as_normals(through_bc1(colors)), true));
        expect("BC5", row.bc5, blocks(false, false));
        expect("BC5, best", row.best, blocks(false, true));
        expect("BC5, signed", row.of_signed, blocks(true, false));
        expect("BC5, signed, best", row.best_signed, blocks(true, true));
    }
}

TEST(NormalMapBlocks, ShowBC1WithTwiceTheErrorOfBC5) {
    for (const char* map : {"shapes", "bricks", "paving"}) {
        const auto error_with = [&](const char* format) {
            std::vector<Knob> knobs = one(format);
            knobs.emplace_back("map", map);
            Shot shot = shot_of("02", knobs, "normal", {128, 128});
            shot.camera = {.yaw = 0, .pitch = 0, .distance = 3};
            return error_of("02", shot).mean;
        };
        EXPECT_GT(error_with("bc1"), 2 * error_with("bc5")) << map;
        EXPECT_GT(error_with("bc1"), 2 * error_with("bc5-snorm")) << map;
    }
}

Shot four_tiles(const char* format, const char* repeat) {
    std::vector<Knob> knobs = one(format);
    knobs.insert(knobs.end(), {{"map", "shapes"}, {"repeat", repeat}});
    Shot shot = shot_of("02", knobs, "normal", {128, 128});
    shot.camera = {.yaw = 0, .pitch = 0, .distance = 3};
    return shot;
}

TEST(NormalMapBlocks, MirroredAndWrappedTilesHaveTheErrorOfTheMap) {
    for (const char* format : {"bc5", "bc5-snorm"}) {
        const double alone = error_of("02", four_tiles(format, "once")).mean;
        // The pixels of four tiles meet other texels of the map.
        for (const char* repeat : {"wrapped", "mirrored"})
            EXPECT_NEAR(error_of("02", four_tiles(format, repeat)).mean, alone, 0.2 * alone) << format << ' ' << repeat;
    }
}

TEST(NormalMapBlocks, AMirroredBorderShowsThatUnsignedBytesHaveNoZero) {
    // The border of the map is flat, and the seam is in the middle of the picture.
    const auto jump = [](const char* format, const char* repeat) {
        const Image normals = drawn("02", four_tiles(format, repeat));
        return glm::degrees(double(normals.pixel(64, 64)[0]) - double(normals.pixel(63, 64)[0]));
    };
    EXPECT_NEAR(std::abs(jump("bc5", "mirrored")), glm::degrees(2 * 0.5 / 127.5), 1e-3);
    EXPECT_EQ(jump("bc5", "wrapped"), 0);
    EXPECT_EQ(jump("bc5-snorm", "mirrored"), 0);
}

TEST(NormalMapTextures, OfSignedBytesHaveTheErrorsOfTheHandout) {
    const Image normals = normal_map(MapName::shapes);
    Image codes = normals;
    for (float& value : codes.values) value = std::round(127 * value) / 127;
    // Measured once; this test repeats it.
    const auto expect = [&](double mean, double largest, const Image& read) {
        const Degrees error = error_in_degrees(normals, read, true);
        EXPECT_NEAR(error.mean, mean, 0.001);
        EXPECT_NEAR(error.largest, largest, 0.001);
    };
    expect(0.191, 0.331, as_normals(in_bytes(as_colors(normals))));
    expect(0.142, 0.326, codes);
    expect(51.437, 60.407, as_normals(codes));
}

/// Returns the probe `normal` in a tile of the view `snorm`, from its upper left pixel with a surface.
std::vector<glm::vec3> normals_in_tile(const Image& probe, size_t tile) {
    const glm::ivec2 size(probe.width, probe.height);
    const auto [corner, extent, foot] =
        Labels::with_feet(size, tiles_of(size, 4, Labels::scale_height(size)), 2, 42)[tile];
    std::vector<glm::vec3> normals;
    for (int y = size.y - corner.y - extent.y; y < size.y - corner.y; ++y)
        for (int x = corner.x; x < corner.x + extent.x; ++x)
            if (const float* n = probe.pixel(x, y); n[0] != no_surface) normals.emplace_back(n[0], n[1], n[2]);
    return normals;
}

TEST(NormalMapTextures, OfSignedBytesAreReadWithoutTheRuleOfUnsignedOnes) {
    Shot shot = shot_of("02", {{"view", "snorm"}}, "normal", {320, 321});
    shot.camera = {.yaw = 0, .pitch = 0, .distance = 4};
    const Image probe = drawn("02", shot);
    const auto unsigned_bytes = normals_in_tile(probe, 0), as_read = normals_in_tile(probe, 1),
               codes = normals_in_tile(probe, 2), twice = normals_in_tile(probe, 3);
    ASSERT_GT(as_read.size(), 2000u);
    ASSERT_EQ(as_read.size(), codes.size());
    for (size_t i = 0; i < codes.size(); ++i)
        ASSERT_LT(glm::length(as_read[i] - codes[i]), 1e-6) << "code / 127, in single precision";
    // The first pixel is on the flat border of the map.
    EXPECT_EQ(as_read[0], glm::vec3(0, 0, 1));
    EXPECT_EQ(twice[0], glm::vec3(-1, -1, 1));
    EXPECT_NEAR(glm::degrees(std::atan(glm::length(glm::vec2(unsigned_bytes[0])))), 0.318, 1e-3);
}

TEST(NormalMapTextures, ShowHeightsOfWhichTheNormalsAreTheSlopes) {
    // Central differences over a texel; rims and ridges, where the slope jumps, are left out by the median.
    const Image normals = normal_map(MapName::shapes), heights = storage::height_map(MapName::shapes);
    std::vector<double> off;
    for (int y = 1; y + 1 < heights.height; ++y)
        for (int x = 1; x + 1 < heights.width; ++x) {
            const auto slope = [&](int dx, int dy) {  // height 1 is 0.3, and a texel 1/32, of half the map
                return 0.3 * (*heights.pixel(x - dx, y - dy) - *heights.pixel(x + dx, y + dy)) * 16;
            };
            const float* n = normals.pixel(x, y);
            off.push_back(std::hypot(slope(1, 0) - n[0] / n[2], slope(0, -1) - n[1] / n[2]));
        }
    std::nth_element(off.begin(), off.begin() + ptrdiff_t(off.size() / 2), off.end());
    EXPECT_LT(off[off.size() / 2], 0.03);
}

TEST(NormalMapTextures, HaveAVectorOnEachTexelAlongItsNormal) {
    Shot shot = shot_of("02", {{"view", "field"}}, "", {960, 960});
    shot.camera = {.yaw = 0, .pitch = 0, .distance = 2.8};
    const Image picture = drawn("02", shot), normals = normal_map(MapName::shapes);
    const glm::dmat4 clip_from_world = Camera(shot.camera, 1).clip_from_world();
    const auto color_at = [&](glm::dvec3 place) {
        const glm::dvec4 clip = clip_from_world * glm::dvec4(place, 1);
        const glm::ivec2 pixel(480 + 480 * clip.x / clip.w, 480 - 480 * clip.y / clip.w);
        const float* color = picture.pixel(pixel.x, pixel.y);
        return glm::vec3(color[0], color[1], color[2]);
    };
    int seen = 0;
    for (int y = 6; y < 26; ++y)
        for (int x = 6; x < 26; ++x) {  // all on the dome
            const float* n = normals.pixel(x, y);
            if (std::hypot(n[0], n[1]) < 0.4) continue;  // short, seen from above
            const glm::dvec3 foot((x + 0.5) / 16 - 1, 1 - (y + 0.5) / 16, 0), along(n[0], n[1], n[2]);
            const glm::vec3 needle = color_at(foot + 0.7 * 3.4 / 32 * along);
            // Needles have no hue: 70 % of (1, 0.97, 0.85). The map's colours are blue and bright.
            EXPECT_NEAR(needle.x - needle.z, 0.12, 0.1) << x << ' ' << y;
            ++seen;
        }
    EXPECT_GT(seen, 200);
}

TEST(NormalMapBlocks, MixNoTexelsOfTwoTiles) {
    // Two tiles of 8 x 8 texels side by side, and their left one alone.
    Image both = normal_map(MapName::shapes), left(8, 8, 3);
    Image atlas(16, 8, 3);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 16; ++x)
            for (int c = 0; c < 3; ++c) {
                atlas.pixel(x, y)[c] = both.pixel(x < 8 ? 4 + x : 40 + x, 8 + y)[c];
                if (x < 8) left.pixel(x, y)[c] = atlas.pixel(x, y)[c];
            }
    const BlockMap of_both = compress(atlas, false), of_left = compress(left, false);
    for (size_t row = 0; row < 2; ++row)
        for (size_t i = 0; i < 32; ++i) EXPECT_EQ(of_both.bytes[row * 64 + i], of_left.bytes[row * 32 + i]);
}

TEST(NormalMapBlocks, RepeatTheBorderOfAMapWhoseSizeIsNoMultipleOfFour) {
    // A map of 6 x 5 texels has 2 x 2 blocks. x is -0.5 in the first four columns, and 0.5 in the last two.
    Image map(6, 5, 3);
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 6; ++x) map.pixel(x, y)[0] = x < 4 ? -0.5f : 0.5f;
    const BlockMap stored = compress(map, true);
    ASSERT_EQ(stored.bytes.size(), 4u * 16);
    for (size_t block = 0; block < 4; ++block)
        for (const double value :
             rgtc_decode(rgtc_block(channel_bytes(stored, 2 * block), RgtcKind::snorm), RgtcKind::snorm))
            EXPECT_NEAR(value, block % 2 ? 0.5 : -0.5, 0.5 / 127 + 1e-9) << "block " << block;
}

TEST(NormalMapBlocks, RefuseAMapThatIsNotFinite) {
    Image map(4, 4, 3);
    map.pixel(2, 1)[1] = std::numeric_limits<float>::quiet_NaN();
    try {
        compress(map, false);
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "the normal in column 2, row 1 of the map is not finite");
    }
}

TEST(NormalMapBlocks, RefuseEndsAndIndicesOutOfRange) {
    EXPECT_THROW(storage::packed({.first = 256}, false), Error);
    EXPECT_THROW(storage::packed({.first = -128}, true), Error);
    storage::ChannelBlock block;
    block.indices[3] = 8;
    EXPECT_THROW(storage::packed(block, false), Error);
}

}  // namespace
}  // namespace relief
