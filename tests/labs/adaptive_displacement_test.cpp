// Lab 14: levels are those of the twins, at every place and from everywhere; edges agree where patches do not; nothing
// that is seen is culled; and nothing is left that is not a number.
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <random>
#include <set>

#include "framework/lab/displaced_surface.h"
#include "framework/reference/tessellation.h"
#include "tests/labs/feedback.h"
#include "tests/labs/shots.h"

namespace relief {
namespace {

constexpr unsigned seed = 14;

struct Dice {
    std::mt19937 random{seed};
    double between(double low, double high) { return std::uniform_real_distribution(low, high)(random); }
    template <size_t count>
    const char* one_of(const char* const (&names)[count]) {
        return names[random() % count];
    }
    /// At a place where it sees the surface, or a part of it, or nothing.
    Orbit view(double nearest, double farthest) {
        return {.yaw = between(0, 360),
                .pitch = between(-89, 89),
                .distance = nearest * std::pow(farthest / nearest, between(0, 1)),
                .target = {between(-0.4, 0.4), between(-0.4, 0.4), between(-0.4, 0.4)},
                .field_of_view = between(5, 80)};
    }
};

Shot eye(std::vector<Knob> knobs, const char* probe = "", glm::ivec2 size = {128, 128}) {
    knobs.emplace(knobs.begin(), "view", "eye");
    return shot_of("14", std::move(knobs), probe, size);
}

using Triangle = std::array<float, 9>;

std::multiset<Triangle> triangles(Lab& lab, const Shot& shot, const char* cull) {
    set_knob(lab, "cull", cull);
    const std::vector<glm::vec3> corners = triangles_of(lab, shot);
    std::multiset<Triangle> result;
    for (size_t i = 0; i < corners.size(); i += 3) {
        Triangle triangle;
        for (size_t k = 0; k < 9; ++k) triangle[k] = corners[i + k / 3][int(k % 3)];
        result.insert(triangle);
    }
    return result;
}

/// Whether it is nowhere in front of one of the planes of the picture, or seen from behind.
bool is_rightly_culled(const Triangle& triangle, const Camera& camera) {
    std::array<glm::dvec3, 3> place;
    for (int i = 0; i < 3; ++i)
        place[size_t(i)] = {triangle[size_t(3 * i)], triangle[size_t(3 * i + 1)], triangle[size_t(3 * i + 2)]};
    const glm::dvec3 across = glm::cross(place[1] - place[0], place[2] - place[0]);
    // What has no area but that of rounding, some 1e-7 of a metre across, has no side.
    const double longest = std::max(
        {glm::distance(place[0], place[1]), glm::distance(place[1], place[2]), glm::distance(place[2], place[0])});
    if (glm::dot(across, camera.eye() - place[0]) <= 3e-7 * longest * glm::distance(camera.eye(), place[0]))
        return true;
    const glm::dmat4 clip_from_world = camera.clip_from_world();
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0}) {
            bool is_behind = true;
            for (const glm::dvec3& corner : place) {
                const glm::dvec4 clip = clip_from_world * glm::dvec4(corner, 1);
                is_behind = is_behind && sign * clip[axis] + clip.w < 1e-9;
            }
            if (is_behind) return true;
        }
    return false;
}

TEST(AdaptiveDisplacement, OnlyTrianglesThatNobodySeesAreCulled) {
    Dice dice;
    std::printf("seed %u\n", seed);
    const int scenes = getenv("SCENES") ? atoi(getenv("SCENES")) : 24;
    size_t all = 0, wrong = 0, culled = 0;
    for (int scene = 0; scene < scenes; ++scene) {
        const char* const surface = dice.one_of({"sphere", "globe", "torus", "box", "urn", "ground", "column"});
        const bool fades = dice.random() % 3 == 0;
        std::vector<Knob> knobs = {{"surface", surface},
                                   {"corners", dice.one_of({"3", "4"})},
                                   {"patches", dice.one_of({"2", "5", "8", "12"})},
                                   {"map", dice.one_of({"smooth", "fbm", "stones"})},
                                   {"size", "256"},
                                   {"depth", dice.one_of({"0", "0.01", "0.05", "0.2"})},
                                   {"method", dice.one_of({"uniform", "distance", "size", "error"})},
                                   {"level", dice.one_of({"1", "1.3", "2.4", "5.2"})},
                                   {"finest", "3"},
                                   {"segment", dice.one_of({"3", "8"})},
                                   {"spacing", dice.one_of({"equal", "fractional-odd", "fractional-even"})},
                                   {"fade", fades ? "true" : "false"},
                                   {"fade_begin", "2"},
                                   {"fade_end", "4"}};
        Shot shot = eye(knobs, "place", {64, 64});
        const auto lab = make_lab(find_lab("14"), shot);
        size_t here = 0, gone = 0;
        for (int i = 0; i < 6; ++i) {
            shot.camera = dice.view(0.3, 8);
            const Camera camera(shot.camera, 1);
            const auto drawn = triangles(*lab, shot, "none");
            auto left = drawn;
            for (const Triangle& triangle : triangles(*lab, shot, "all")) {
                const auto at = left.find(triangle);
                ASSERT_NE(at, left.end()) << "culling made a triangle";
                left.erase(at);
            }
            here += drawn.size(), gone += left.size();
            for (const Triangle& triangle : left) wrong += !is_rightly_culled(triangle, camera);
        }
        all += here, culled += gone;
        std::string text;
        for (const auto& [name, value] : knobs) text += name + "=" + value + " ";
        if (getenv("VERBOSE"))
            std::printf("%5.1f %% of %zu: %s\n", 100.0 * double(gone) / double(here), here, text.c_str());
        ASSERT_EQ(wrong, 0u) << text;
    }
    EXPECT_GT(culled, all / 4) << culled << " of " << all;
}

}  // namespace
}  // namespace relief
