// Bounds of a relief on a patch, which no height exceeds, and errors that are known analytically.
#include "labs/14_adaptive_displacement/patch_heights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "framework/core/image/mips.h"
#include "framework/library/maps/test_maps.h"
#include "framework/staff/reference/height_field.h"

namespace relief {
namespace {

constexpr unsigned patches_seed = 8;
constexpr double rounding = 1 / 255.0;  // how much the bounds are widened

class Random {
public:
    double operator()(double low, double high) { return std::uniform_real_distribution<>(low, high)(bits_); }
    glm::vec2 place(double reach) { return {(*this)(-reach, reach), (*this)(-reach, reach)}; }
    unsigned below(unsigned end) { return unsigned(bits_()) % end; }

private:
    std::mt19937 bits_{patches_seed};
};

Image patch_noise(int width, int height) {
    Random random;
    Image image(width, height, 1);
    for (float& v : image.values) v = float(random(0, 1));
    return image;
}

/// Returns a map of `h(u, v)` at the texel centres.
template <class Function>
Image map_of(int width, int height, const Function& h) {
    Image image(width, height, 1);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            *image.pixel(x, height - 1 - y) = float(h((x + 0.5) / width, (y + 0.5) / height));
    return image;
}

std::vector<std::pair<std::string, Image>> maps() {
    std::vector<std::pair<std::string, Image>> result{{"24x10", patch_noise(24, 10)}, {"7x64", patch_noise(7, 64)}};
    for (const HeightMap map :
         {HeightMap::fbm, HeightMap::bricks, HeightMap::posts, HeightMap::stones, HeightMap::plateau})
        result.emplace_back(height_map_names[size_t(map)], make_height_map(map, 64));
    return result;
}

/// A map at all its mip levels, and between them.
class Levels {
public:
    explicit Levels(const Image& heights) {
        for (const Image& level : mip_chain(heights, ColorSpace::linear)) fields_.emplace_back(level, true);
    }
    double last() const { return double(fields_.size() - 1); }
    double height(glm::dvec2 uv, double level) const {
        const double whole = std::floor(level), next = std::min(whole + 1, last());
        return at(uv, whole) * (1 - (level - whole)) + at(uv, next) * (level - whole);
    }

private:
    double at(glm::dvec2 uv, double level) const {
        const HeightField& field = fields_[size_t(level)];
        return field.height(uv * glm::dvec2(field.size()));
    }
    std::vector<HeightField> fields_;
};

using Patch = std::vector<HeightCorner>;

/// Returns a flat patch that owns its edges and corners; a tile is one metre wide.
Patch patch_of(const std::vector<glm::vec2>& uv) {
    Patch patch;
    for (size_t i = 0; i < uv.size(); ++i)
        patch.push_back({glm::vec3(uv[i], 0), uv[i], uv[i], glm::vec4(uv[i], uv[(i + 1) % uv.size()])});
    return patch;
}

/// Returns a convex patch of three or four corners at a random position.
Patch random_patch(Random& random, size_t corners) {
    const glm::vec2 middle = random.place(3);
    const double size = std::pow(10, random(-2.5, -0.2)), turn = random(0, 7);
    std::vector<glm::vec2> uv;
    for (size_t i = 0; i < corners; ++i) {
        const double angle = turn + (double(i) + random(-0.25, 0.25)) * 2 * M_PI / double(corners);
        uv.push_back(middle + float(size) * glm::vec2(std::cos(angle), std::sin(angle)));
    }
    return patch_of(uv);
}

Patch square(glm::vec2 at, float side) {
    return patch_of({at, at + glm::vec2(side, 0), at + side, at + glm::vec2(0, side)});
}

/// Interpolates a member of the corners: bilinearly for a quad; for a triangle at barycentric (1 - s - t, s, t).
template <int length>
auto inside(const Patch& patch, glm::vec<length, float> HeightCorner::*member, double s, double t) {
    const auto at = [&](size_t i) { return glm::vec<length, double>(patch[i].*member); };
    if (patch.size() == 3) return at(0) * (1 - s - t) + at(1) * s + at(2) * t;
    return (at(0) * (1 - s) + at(1) * s) * (1 - t) + (at(3) * (1 - s) + at(2) * s) * t;
}

glm::dvec2 random_place(Random& random, const Patch& patch) {
    const glm::dvec2 place(random(0, 1), random(0, 1));
    return patch.size() == 3 && place.x + place.y > 1 ? 1.0 - place : place;
}

PatchHeights measured(const Patch& patch, const Image& heights) {
    return measure_patches(patch, int(patch.size()), heights).at(0);
}

TEST(PatchHeights, BoundFilteredHeightsAtEveryMipLevel) {
    Random random;
    for (const auto& [name, heights] : maps()) {
        const Levels levels(heights);
        for (int i = 0; i < 200; ++i) {
            Patch patch = random_patch(random, 3 + i % 2);
            if (i % 3 == 0) patch[1].height_uv = random.place(2);
            if (i % 3 == 1) patch[2].edge_uv = {random.place(2), random.place(2)};
            const PatchHeights bounds = measured(patch, heights);
            for (int k = 0; k < 200; ++k) {
                const HeightCorner& corner = patch[random.below(unsigned(patch.size()))];
                const glm::dvec2 place = random_place(random, patch);
                const glm::dvec2 from(corner.edge_uv), to(corner.edge_uv.z, corner.edge_uv.w);
                const double level = k % 2 ? random(0, levels.last()) : std::floor(random(0, levels.last() + 1));
                for (const glm::dvec2 uv : {inside(patch, &HeightCorner::uv, place.x, place.y),
                                            from + (to - from) * place.x, glm::dvec2(corner.height_uv)}) {
                    const double h = levels.height(uv, level);
                    ASSERT_GE(h, bounds.lowest + rounding - 1e-6) << name << ", patch " << i << ", level " << level;
                    ASSERT_LE(h, bounds.highest - rounding + 1e-6) << name << ", patch " << i << ", level " << level;
                }
            }
        }
    }
}

TEST(PatchHeights, BoundHeightsTightly) {
    const Image heights = make_height_map(HeightMap::smooth, 256);
    const Levels levels(heights);
    Patch terrain;
    for (int i = 0; i < 32 * 32; ++i)
        for (const HeightCorner& corner : square(glm::vec2(i % 32, i / 32) / 32.0f, 1 / 32.0f))
            terrain.push_back(corner);
    double said = 0, there = 0;
    for (const PatchHeights& bounds : measure_patches(terrain, 4, heights))
        said += bounds.highest - bounds.lowest - 2 * rounding;
    for (size_t i = 0; i < terrain.size(); i += 4) {
        double low = 1, high = 0;
        for (int k = 0; k < 17 * 17; ++k)
            for (double level = 0; level <= levels.last(); ++level) {
                const double h = levels.height(glm::dvec2(terrain[i].uv) + glm::dvec2(k % 17, k / 17) / 512.0, level);
                low = std::min(low, h), high = std::max(high, h);
            }
        there += high - low;
    }
    EXPECT_LT(said, there * 1.1);
    EXPECT_LT(said, 0.25 * double(terrain.size() / 4)) << "the map's range is 1";
}

TEST(PatchHeights, BoundTheSlopeBetweenAnyTwoPoints) {
    Random random;
    for (const auto& [name, heights] : maps()) {
        const Levels levels(heights);
        for (int i = 0; i < 200; ++i) {
            Patch patch = random_patch(random, 3 + i % 2);
            const glm::vec3 across(random.place(1), random(-1, 1)), up(random.place(1), random(-1, 1));
            for (HeightCorner& corner : patch)  // sheared, and half of them mirrored
                corner.position = corner.position.x * across + corner.position.y * up;
            if (i % 4 == 1) patch[2].position += 0.3f * (patch[1].position - patch[0].position);
            if (i % 4 == 3) {
                const glm::vec3 a = patch[1].position - patch[0].position, b = patch[3].position - patch[0].position;
                patch[2].position += 0.4f * glm::cross(a, b) / std::sqrt(glm::length(glm::cross(a, b)));
            }
            const double slope = measured(patch, heights).slope;
            for (int k = 0; k < 200; ++k) {
                const glm::dvec2 from = random_place(random, patch);
                const double share = std::pow(10, random(-3, 0));  // log-uniform in [0.001, 1]: close pairs, too
                const glm::dvec2 to = from + (random_place(random, patch) - from) * share;
                const double level = std::floor(random(0, levels.last() + 1));
                const auto height = [&](glm::dvec2 place) {
                    return levels.height(inside(patch, &HeightCorner::uv, place.x, place.y), level);
                };
                const double metres = glm::distance(inside(patch, &HeightCorner::position, from.x, from.y),
                                                    inside(patch, &HeightCorner::position, to.x, to.y));
                ASSERT_LE(std::abs(height(to) - height(from)), slope * metres * (1 + 1e-5) + 1e-9)
                    << name << ", patch " << i << ", level " << level;
            }
        }
    }
}

TEST(PatchHeights, HaveTheExactSlopeOfARoof) {
    // The slope is 2 per tile everywhere. Coarser levels average two equal sides at the ridge, which is no steeper.
    const Image roof = map_of(128, 32, [](double u, double) { return std::abs(2 * u - 1); });
    for (Patch patch : {square({0.1f, 0.3f}, 0.2f), patch_of({{0.1f, 0.1f}, {0.4f, 0.2f}, {0.2f, 0.9f}})}) {
        EXPECT_NEAR(measured(patch, roof).slope, 2, 1e-4);
        for (HeightCorner& corner : patch) corner.position.x += 4 * corner.position.y;  // steeper across the shear
        EXPECT_NEAR(measured(patch, roof).slope, 2 * std::sqrt(17.0), 1e-3);
        for (HeightCorner& corner : patch) corner.position *= 10;
        EXPECT_NEAR(measured(patch, roof).slope, 0.2 * std::sqrt(17.0), 1e-4);
    }
}

TEST(PatchHeights, BoundTheSlopeInTheMiddleOfATwistedQuad) {
    // The midline is 0.2 long, shorter than the lower and the upper side: the slope is 2 per metre.
    const Image roof = map_of(128, 32, [](double u, double) { return std::abs(2 * u - 1); });
    Patch patch = square({0.1f, 0.3f}, 0.2f);
    patch[1].position.z = -0.1f, patch[2].position.z = 0.1f;
    EXPECT_GE(measured(patch, roof).slope, 2);
    EXPECT_LE(measured(patch, roof).slope, 2.5);
}

TEST(PatchHeights, APlaneHasNoErrors) {
    const Image roof = map_of(128, 32, [](double u, double) { return std::abs(2 * u - 1); });
    for (const Patch& patch : {square({0.1f, 0.3f}, 0.2f), patch_of({{0.1f, 0.1f}, {0.4f, 0.2f}, {0.2f, 0.9f}})}) {
        const PatchHeights heights = measured(patch, roof);
        for (const float error : heights.inside) EXPECT_LT(error, 2e-7f);
        for (const LevelErrors& edge : heights.edges)
            for (const float error : edge) EXPECT_LT(error, 2e-7f);
    }
}

TEST(PatchHeights, ErrorsMatchTheChordError) {
    // The error of a chord is at most (L / n)² |h''| / 8. The root mean square of a parabola is sqrt(8 / 15) of its
    // maximum. Over the patch, the RMS of |h''| is 0.905 of its maximum, which is in the middle. Valid for chords of at
    // least 4 texels.
    const double side = 0.25, bend = 2 * M_PI * M_PI;
    const Image waves = map_of(256, 16, [](double u, double) { return 0.5 + 0.5 * std::sin(2 * M_PI * u); });
    const Patch corners = square({0.125f, 0.3f}, float(side));
    const PatchHeights quad = measured(corners, waves);
    const PatchHeights triangle = measured({corners[0], corners[1], corners[2]}, waves);
    for (int k = 0; k < 5; ++k) {
        const double n = 1 << k, expected = 3 * 0.905 * std::sqrt(8.0 / 15) * side * side / (n * n) * bend / 8;
        const size_t i = size_t(k);
        for (const float error :
             {quad.inside[i], quad.edges[0][i], quad.edges[2][i], triangle.inside[i], triangle.edges[0][i]})
            EXPECT_NEAR(error, expected, 0.1 * expected) << "level " << n;
        EXPECT_LT(quad.edges[1][i], 1e-7) << "along the wave";
    }
}

TEST(PatchHeights, ErrorsCoverBothDiagonalsOfAQuadsCells) {
    // A valley from corner to corner: the diagonal across it is a bridge.
    const float side = 0.25f;
    for (const bool rises : {true, false}) {
        const Image valley =
            map_of(256, 256, [&](double u, double v) { return std::abs(rises ? u - v : u + v - 1.25); });
        const PatchHeights heights = measured(square({0.5f, 0.5f}, side), valley);
        for (int k = 0; k < 4; ++k)
            EXPECT_GE(heights.inside[size_t(k)], side / float(2 << k) - 0.002f) << rises << ", octave " << k;
    }
}

TEST(PatchHeights, ErrorsAreNonIncreasing) {
    Random random;
    const Image rough = patch_noise(40, 24);
    for (int i = 0; i < 100; ++i) {
        const PatchHeights heights = measured(random_patch(random, 3 + i % 2), rough);
        for (size_t k = 1; k < level_octaves; ++k) {
            EXPECT_LE(heights.inside[k], heights.inside[k - 1]);
            for (const LevelErrors& edge : heights.edges) EXPECT_LE(edge[k], edge[k - 1]);
        }
        EXPECT_GT(heights.inside[0], 0);
    }
}

/// Returns the chord surface of `height(x, y)` on [0, 1]², or on the triangle below the falling diagonal, with n cuts
/// along a side.
template <class Height>
double chord_at(const Height& height, glm::dvec2 place, double n, bool is_falling) {
    const glm::dvec2 cell = glm::floor(place * n), at = place * n - cell;
    const auto corner = [&](double x, double y) { return height((cell + glm::dvec2(x, y)) / n); };
    if (is_falling && at.x + at.y <= 1)
        return corner(0, 0) * (1 - at.x - at.y) + corner(1, 0) * at.x + corner(0, 1) * at.y;
    if (is_falling) return corner(1, 1) * (at.x + at.y - 1) + corner(0, 1) * (1 - at.x) + corner(1, 0) * (1 - at.y);
    if (at.x > at.y) return corner(0, 0) * (1 - at.x) + corner(1, 0) * (at.x - at.y) + corner(1, 1) * at.y;
    return corner(0, 0) * (1 - at.y) + corner(0, 1) * (at.y - at.x) + corner(1, 1) * at.x;
}

TEST(PatchHeights, ChordsNeverExceedTwiceTheErrorAndRarelyTheErrorItself) {
    Random random;
    const double missed = 1.5e-4;  // error of a kink between two samples, on patches of a few texels
    for (const auto& [map, slack] : {std::pair(HeightMap::smooth, 1.2), {HeightMap::fbm, 1.3}}) {
        const Image heights = make_height_map(map, 64);
        const Levels levels(heights);
        size_t count = 0, beyond = 0;
        for (int i = 0; i < 300; ++i) {
            const Patch patch = random_patch(random, 3 + i % 2);
            const PatchHeights said = measured(patch, heights);
            const auto in_patch = [&](glm::dvec2 place) {
                return levels.height(inside(patch, &HeightCorner::uv, place.x, place.y), 0);
            };
            const auto on_edge = [&](glm::dvec2 place) {
                return levels.height(glm::mix(glm::dvec2(patch[2].uv), glm::dvec2(patch[3 % patch.size()].uv), place.x),
                                     0);
            };
            for (int k = 0; k < 1000; ++k) {
                const size_t octave = random.below(level_octaves);
                const double n = 1 << octave;
                const glm::dvec2 place = random_place(random, patch);
                const bool is_falling = patch.size() == 3 || random.below(2);
                const double inside_off = std::abs(chord_at(in_patch, place, n, is_falling) - in_patch(place));
                const double edge_off = std::abs(chord_at(on_edge, {place.x, 0}, n, true) - on_edge(place));
                EXPECT_LE(inside_off, 2 * said.inside[octave] * slack + missed)
                    << height_map_names[size_t(map)] << ", patch " << i << ", level " << n;
                EXPECT_LE(edge_off, 2 * said.edges[2][octave] * slack + missed)
                    << height_map_names[size_t(map)] << ", edge of patch " << i << ", level " << n;
                ++count, beyond += inside_off > said.inside[octave] + missed;
            }
        }
        EXPECT_LT(beyond, count / 100) << height_map_names[size_t(map)];
    }
}

TEST(PatchHeights, AnEdgeHasTheSameBitsFromBothSides) {
    Random random;
    const Image heights = patch_noise(48, 20);
    for (int i = 0; i < 200; ++i) {
        Patch patch = random_patch(random, 3), other = random_patch(random, 4);
        const glm::vec4 uv = patch[0].edge_uv;
        other[2].edge_uv = {uv.z, uv.w, uv.x, uv.y};
        const PatchHeights here = measured(patch, heights), there = measured(other, heights);
        EXPECT_EQ(here.edges[0], there.edges[2]) << i;
        EXPECT_EQ(here.edge_heights[0], there.edge_heights[2]) << i;
    }
}

void expect_finite(const PatchHeights& heights) {
    EXPECT_TRUE(std::isfinite(heights.slope));
    for (const float error : heights.inside) EXPECT_TRUE(std::isfinite(error));
    for (const LevelErrors& edge : heights.edges)
        for (const float error : edge) EXPECT_TRUE(std::isfinite(error));
}

TEST(PatchHeights, ADegeneratePatchIsFinite) {
    const Image heights = patch_noise(16, 16);
    const Image flat = make_height_map(HeightMap::plateau, 16);
    for (const size_t corners : {3, 4}) {
        Random random;
        Patch in_a_point = random_patch(random, corners), on_a_line = in_a_point, one_uv = in_a_point;
        for (HeightCorner& corner : in_a_point) corner.position = {1, 2, 3};
        for (HeightCorner& corner : on_a_line) corner.position.y = 0;
        for (HeightCorner& corner : one_uv) corner.uv = {0.3f, 0.4f};
        EXPECT_EQ(measured(in_a_point, heights).slope, 1e6f);
        EXPECT_EQ(measured(on_a_line, heights).slope, 1e6f);
        EXPECT_EQ(measured(in_a_point, flat).slope, 0);
        EXPECT_EQ(measured(one_uv, heights).slope, 0);
        for (const float bad : {NAN, INFINITY, 1e30f}) {
            Patch wild = on_a_line;
            wild[1].uv.x = wild[0].edge_uv.y = wild[2].height_uv.x = bad;
            for (const Patch& patch : {in_a_point, on_a_line, one_uv, wild}) expect_finite(measured(patch, heights));
        }
    }
    EXPECT_TRUE(measure_patches({}, 4, heights).empty());
}

TEST(PatchHeights, UseFewerSamplesPerPatchForManyPatches) {
    EXPECT_EQ(densest_samples(1), 128);
    EXPECT_EQ(densest_samples(1296), 128) << "the ground of lab 14";
    for (const size_t patches : {size_t(5000), size_t(49152), size_t(150000)}) {
        const double side = densest_samples(patches);
        EXPECT_GE(side, 16);  // with fewer samples, the errors of neighbouring levels may be indistinguishable
        EXPECT_LE(double(patches) * side * side, 64e6);
    }
}

TEST(PatchHeights, IgnoreNanHeights) {
    Image heights = patch_noise(16, 16);
    heights.values[40] = NAN;
    const PatchHeights said = measured(square({0.2f, 0.2f}, 0.9f), heights);
    expect_finite(said);
    EXPECT_LT(said.highest, 1.1f);
    EXPECT_GT(said.lowest, -0.1f);
}

TEST(PatchHeights, AMapOfOneTexelHasNoSlopeAndNoError) {
    Image heights(1, 1, 1);
    heights.values = {0.25f};
    Random random;
    for (const size_t corners : {3, 4}) {
        const PatchHeights said = measured(random_patch(random, corners), heights);
        EXPECT_FLOAT_EQ(said.lowest, 0.25f - 1 / 255.0f);
        EXPECT_FLOAT_EQ(said.highest, 0.25f + 1 / 255.0f);
        EXPECT_EQ(said.slope, 0);
        EXPECT_EQ(said.inside, LevelErrors{});
        for (const LevelErrors& edge : said.edges) EXPECT_EQ(edge, LevelErrors{});
    }
}

}  // namespace
}  // namespace relief
