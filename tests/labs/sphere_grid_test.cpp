// Grids on a sphere: faces that meet, and places that are found again.
#include "labs/09_planet/sphere_grid.h"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <set>

namespace relief {
namespace {

constexpr std::array grid_mappings = {SphereMapping::equal_angle, SphereMapping::gnomonic, SphereMapping::lat_long};

glm::dvec3 random_direction(std::mt19937& random) {
    std::uniform_real_distribution<double> between(-1, 1);
    while (true) {
        const glm::dvec3 at(between(random), between(random), between(random));
        if (const double length = glm::length(at); length > 0.1 && length < 1) return at / length;
    }
}

TEST(SphereGrid, FindsThePlaceOfADirectionAndThePatchThatHasIt) {
    std::mt19937 random(9);
    for (const SphereMapping mapping : grid_mappings)
        for (int i = 0; i < 300; ++i) {
            const glm::dvec3 r = random_direction(random);
            const auto [face, st] = face_place(mapping, r);
            // A few roundings of coordinates up to 1.
            EXPECT_LT(glm::distance(direction_at(mapping, face, st), r), 1e-14);
            for (int level = 0; level <= 12; ++level) {
                const SpherePatch patch = patch_at(face, st, level);
                const glm::dvec2 low = patch.on_face({0, 0}), high = patch.on_face({1, 1});
                EXPECT_TRUE(low.x <= st.x && st.x <= high.x && low.y <= st.y && st.y <= high.y) << level;
                if (level < 12) {
                    int children = 0;
                    for (int k = 0; k < 4; ++k) children += patch.child(k) == patch_at(face, st, level + 1);
                    EXPECT_EQ(children, 1);
                }
            }
        }
}

TEST(SphereGrid, FacesShareTheirCornersToTheLastBit) {
    constexpr std::array<glm::dvec2, 4> corners = {{{-1, -1}, {1, -1}, {-1, 1}, {1, 1}}};
    for (const SphereMapping mapping : grid_mappings)
        for (int face = 0; face < face_count(mapping); ++face)
            for (const glm::dvec2 corner : corners) {
                std::set<std::array<double, 3>> met;
                for (int other = 0; other < face_count(mapping); ++other)
                    for (const glm::dvec2 at : corners) {
                        const glm::dvec3 here = direction_at(mapping, other, at);
                        if (glm::distance(here, direction_at(mapping, face, corner)) < 1e-9)
                            met.insert({here.x + 0.0, here.y + 0.0, here.z + 0.0});
                    }
                EXPECT_EQ(met.size(), 1u);
            }
}

}  // namespace
}  // namespace relief
