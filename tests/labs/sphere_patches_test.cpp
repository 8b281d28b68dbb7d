// Patches of a sphere: bounds that enclose the ground, and covers whose neighbours differ by one level.
#include "labs/09_planet/sphere_patches.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "tests/labs/shots.h"

namespace relief {
namespace {

constexpr std::array mappings = {SphereMapping::equal_angle, SphereMapping::gnomonic, SphereMapping::lat_long};

/// Waves of three sizes, between 0 and 0.12.
double wavy(const glm::dvec3& r) {
    double sum = 0.06;
    for (const double scale : {3.0, 11.0, 40.0})
        sum += 0.06 / scale * (std::sin(scale * r.x) + std::sin(scale * r.y + 1) + std::sin(scale * r.z + 2));
    return sum;
}

TEST(SpherePatches, BoundsEncloseTheGround) {
    Dice dice(9);
    for (const SphereMapping mapping : mappings) {
        const PatchedSphere sphere(mapping, 16, wavy);
        for (int i = 0; i < 2000; ++i) {
            const glm::dvec3 r = dice.direction();
            const auto [face, st] = face_place(mapping, r);
            const PatchBounds bounds = sphere.bounds(patch_at(face, st, i % 8));
            EXPECT_LE(glm::distance((1 + wavy(r)) * r, bounds.middle), bounds.radius) << i % 8;
            EXPECT_LE(std::acos(std::min(1.0, glm::dot(r, bounds.direction))), bounds.angle + 1e-7) << "acos near 1";
            EXPECT_LE(wavy(r), bounds.highest);
        }
    }
}

TEST(SpherePatches, ErrorsFallToAQuarterFromLevelToLevel) {
    const PatchedSphere sphere(SphereMapping::equal_angle, 16, wavy);
    for (size_t level = 1; level <= deepest_level; ++level) {
        EXPECT_LE(sphere.errors()[level], sphere.errors()[level - 1]);
        EXPECT_LE(sphere.usual_errors()[level], sphere.errors()[level]);
        // Half the side means a quarter of the error where triangles are smaller than the waves. Samples find a
        // quarter to a third of it.
        if (level > 2) {
            EXPECT_LT(sphere.errors()[level], 0.34 * sphere.errors()[level - 1]) << level;
        }
    }
    // A smooth ball: the sagitta of a chord over a quad's diagonal, with the margin of errors().
    const PatchedSphere ball(SphereMapping::equal_angle, 16, [](const glm::dvec3&) { return 0.0; });
    const double half_diagonal = 0.5 * std::sqrt(2) * 2 / 16;  // of the largest quad, near the middle of a face
    EXPECT_LT(ball.errors()[0], 1.5 * half_diagonal * half_diagonal / 2);
    EXPECT_GT(ball.errors()[0], 0.3 * half_diagonal * half_diagonal / 2);
    EXPECT_LT(ball.highest(), 1e-5);
}

/// Needs of an eye: patches are split that are nearer than `reach` at level 0, half of it at level 1, and so on.
/// Patches behind the eye are culled.
std::function<PatchNeed(const SpherePatch&)> seen_from(const PatchedSphere& sphere, const glm::dvec3& eye,
                                                       const glm::dvec3& along, double reach) {
    return [&sphere, eye, along, reach](const SpherePatch& id) -> PatchNeed {
        const PatchBounds bounds = sphere.bounds(id);
        const double away = std::max(1e-9, glm::distance(eye, bounds.middle) - bounds.radius);
        const bool is_behind = glm::dot(bounds.middle - eye, along) < -bounds.radius;
        return {is_behind ? Leaf::outside : Leaf::drawn, reach / (1 << id.level) / away};
    };
}

double area_of(const Cover& cover) {
    double faces = 0;
    for (const Leaf& leaf : cover.leaves) faces += std::pow(0.25, leaf.id.level);
    return faces;
}

TEST(SpherePatches, CoverTheSphereOnceAndDrawnNeighboursDifferByOneLevel) {
    Dice dice(9);
    for (const SphereMapping mapping : mappings) {
        const PatchedSphere sphere(mapping, 16, wavy);
        int steps = 0;
        for (int view = 0; view < 20; ++view) {
            const glm::dvec3 eye = (1.12 + std::pow(10, dice.between(-6, 0))) * dice.direction();
            const Cover all = cover_sphere(mapping, 6144, seen_from(sphere, eye, dice.direction(), 2));
            EXPECT_EQ(area_of(all), face_count(mapping));
            std::map<SpherePatch, Leaf::State> states;
            for (const Leaf& leaf : all.leaves) states[leaf.id] = leaf.state;
            const auto drawn_level_at = [&](const glm::dvec3& r) {
                const auto [face, st] = face_place(mapping, r);
                for (int level = 0; level <= deepest_level; ++level)
                    if (const auto found = states.find(patch_at(face, st, level)); found != states.end())
                        return found->second == Leaf::drawn ? level : -1;
                return -1;
            };
            for (const auto& [id, state] : states)
                for (int i = 0; i < 8 && state == Leaf::drawn; ++i)
                    for (const glm::dvec2 beyond : {glm::dvec2((i + 0.5) / 8, -0.01),
                                                    {(i + 0.5) / 8, 1.01},
                                                    {-0.01, (i + 0.5) / 8},
                                                    {1.01, (i + 0.5) / 8}}) {
                        const int other = drawn_level_at(direction_at(mapping, id.face, id.on_face(beyond)));
                        steps += other >= 0 && other != id.level;
                        if (other >= 0) {
                            ASSERT_LE(std::abs(other - id.level), 1) << "view " << view;
                        }
                    }
        }
        EXPECT_GT(steps, 0) << "levels differ somewhere";
    }
}

TEST(SpherePatches, KeepTheLimitAndSplitTheNearestFirst) {
    Dice dice(9);
    const PatchedSphere sphere(SphereMapping::equal_angle, 16, wavy);
    const auto everywhere = [](const SpherePatch& id) { return PatchNeed{Leaf::drawn, id.level < 5 ? INFINITY : 0}; };
    EXPECT_EQ(cover_sphere(SphereMapping::equal_angle, 6144, everywhere).leaves.size(), 6u << 10);
    EXPECT_FALSE(cover_sphere(SphereMapping::equal_angle, 6144, everywhere).is_bounded);
    for (const size_t most : {size_t(100), size_t(500), size_t(3000)}) {
        const glm::dvec3 eye = 1.13 * dice.direction();
        const Cover bounded =
            cover_sphere(SphereMapping::equal_angle, most, seen_from(sphere, eye, glm::normalize(-eye), 1e6));
        EXPECT_TRUE(bounded.is_bounded);
        EXPECT_LE(bounded.leaves.size(), most);
        EXPECT_GE(bounded.leaves.size(), most / 4);
        EXPECT_EQ(area_of(bounded), 6);
        double nearest = INFINITY;
        int level_near = 0, finest = 0;
        for (const Leaf& leaf : bounded.leaves) {
            finest = std::max(finest, leaf.id.level);
            const double away = glm::distance(eye, sphere.bounds(leaf.id).middle);
            if (away < nearest) nearest = away, level_near = leaf.id.level;
        }
        EXPECT_GE(level_near, finest - 1);
    }
}

}  // namespace
}  // namespace relief
