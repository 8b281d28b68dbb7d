// Lab 14: levels match their twins, from every camera. No visible triangle is culled.
#include <cmath>
#include <set>

#include "framework/library/kit/displaced_surface.h"
#include "framework/staff/measure/drawn_subject.h"
#include "framework/staff/reference/tessellation.h"
#include "labs/14_adaptive_displacement/scene.h"
#include "tests/labs/feedback.h"
#include "tests/labs/shots.h"

namespace relief {
namespace {

constexpr unsigned seed = 14;

/// Returns a random camera. It may see the surface, a part of it, or nothing.
Orbit random_view(Dice& dice, double nearest, double farthest) {
    return {.yaw = dice.between(0, 360),
            .pitch = dice.between(-89, 89),
            .distance = nearest * std::pow(farthest / nearest, dice.between(0, 1)),
            .target = {dice.between(-0.4, 0.4), dice.between(-0.4, 0.4), dice.between(-0.4, 0.4)},
            .field_of_view = dice.between(5, 80)};
}

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

/// Returns whether a triangle lies wholly outside one of the view's clip planes, or faces away from the eye.
bool is_rightly_culled(const Triangle& triangle, const Camera& camera) {
    std::array<glm::dvec3, 3> place;
    for (int i = 0; i < 3; ++i)
        place[size_t(i)] = {triangle[size_t(3 * i)], triangle[size_t(3 * i + 1)], triangle[size_t(3 * i + 2)]};
    const glm::dvec3 across = glm::cross(place[1] - place[0], place[2] - place[0]);
    // A triangle whose area is within rounding, some 1e-7 of a metre across, faces neither way.
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

TEST(AdaptiveDisplacement, CullsOnlyInvisibleTriangles) {
    Dice dice(seed);
    std::printf("seed %u\n", seed);
    size_t all = 0, wrong = 0, culled = 0;
    for (int scene = 0; scene < 12; ++scene) {
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
                                   {"finest", "2.5"},
                                   {"segment", dice.one_of({"6", "12"})},
                                   {"spacing", dice.one_of({"equal", "fractional-odd", "fractional-even"})},
                                   {"fade", fades ? "true" : "false"},
                                   {"fade_begin", "2"},
                                   {"fade_end", "4"}};
        Shot shot = eye(knobs, "place", {64, 64});
        const auto lab = make_lab(find_lab("14"), shot);
        size_t here = 0, gone = 0;
        for (int i = 0; i < 3; ++i) {
            shot.camera = random_view(dice, 0.5, 8);
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
        ASSERT_EQ(wrong, 0u) << text;
    }
    EXPECT_GT(culled, all / 4) << culled << " of " << all;
}

/// Computes the level of each patch in double precision, from the same settings as the lab.
class Twin {
public:
    Twin(DisplacedSurface& surface, const Shot& shot, bool by_error)
        : surface_(surface),
          known_(adaptive::PatchTexture::known_of(surface, by_error)),
          frame_{0, shot.size, 0, Camera(shot.camera, double(shot.size.x) / shot.size.y), {}} {}

    double level(const std::string& method, size_t patch) const {
        const size_t n = size_t(surface_.corners());
        const glm::dvec3 eye = frame_.camera.eye();
        const double pixels = adaptive::pixels_per_radian(frame_), scale = double(surface_.scale());
        const auto place = [&](size_t i) {
            return glm::dvec3(surface_.patches().points[patch * n + i % n].vertex.position);
        };
        const auto direction = [&](size_t i) {
            return glm::dvec3(surface_.patches().points[patch * n + i % n].direction);
        };
        const auto by_error = [&](const LevelErrors& errors, float height, const glm::dvec3& middle,
                                  const glm::dvec3& way, double half) {
            const glm::dvec3 pressed = middle + scale * (double(height) - 1) * glm::normalize(way);
            const double away = std::max(glm::distance(pressed, eye) - half, 0.0);
            std::array<double, 7> all;
            std::copy(errors.begin(), errors.end(), all.begin());
            return level_by_error(all, tolerated(away, adaptive::most_pixels_per_radian(frame_), 2, scale));
        };
        glm::dvec3 centre(0);
        for (size_t i = 0; i < n; ++i) centre += place(i) / double(n);
        double radius = 0, highest = 1;
        for (size_t i = 0; i < n; ++i) {
            const glm::dvec3 a = place(i), b = place(i + 1);
            radius = std::max(radius, glm::distance(centre, a));
            highest =
                std::max(highest, method == "distance" ? level_by_distance(a, b, eye, 2, 9, 4, 0.5)
                                  : method == "size"
                                      ? level_by_size(a, b, eye, pixels, 3)
                                      : by_error(known_[patch].edges[i], known_[patch].edge_heights[i], 0.5 * (a + b),
                                                 direction(i) + direction(i + 1), 0.5 * glm::distance(a, b)));
        }
        if (method != "error") return highest;
        const PatchHeights& known = known_[patch];
        const glm::dvec3 axis = n == 4 ? glm::cross(place(2) - place(0), place(3) - place(1))
                                       : glm::cross(place(1) - place(0), place(2) - place(0));
        return std::max(highest, by_error(known.inside, (known.lowest + known.highest) / 2, centre, axis, radius));
    }

private:
    const DisplacedSurface& surface_;
    std::vector<PatchHeights> known_;
    Frame frame_;
};

TEST(AdaptiveDisplacement, LevelsMatchTheTwins) {
    struct Scene {
        const char* name;
        DisplacedSurface::Shape shape;
        int patches, corners;
    };
    // One patch, more patches than one row of the texture holds, and more than two rows hold.
    for (const auto& [name, shape, patches, corners] : {Scene{"ground", DisplacedSurface::ground, 1, 4},
                                                        {"ground", DisplacedSurface::ground, 9, 4},
                                                        {"ground", DisplacedSurface::ground, 7, 3},
                                                        {"torus", DisplacedSurface::torus, 6, 4},
                                                        {"box", DisplacedSurface::box, 4, 3}})
        for (const std::string method : {"distance", "size", "error"}) {
            Shot shot = eye({{"surface", name},
                             {"patches", std::to_string(patches)},
                             {"corners", std::to_string(corners)},
                             {"map", "smooth"},
                             {"size", "256"},
                             {"depth", "0.1"},
                             {"method", method},
                             {"nearest", "2"},
                             {"farthest", "9"},
                             {"finest", "4"},
                             {"coarsest", "0.5"},
                             {"segment", "3"},
                             {"budget", "2"}},
                            "place", {64, 48});
            shot.camera = {.yaw = 40, .pitch = 30, .distance = shape == DisplacedSurface::ground ? 9.0 : 4.0};
            DisplacedSurface surface;
            surface.shape = shape, surface.density = patches, surface.corners_choice = corners - 3;
            surface.material.map = 0, surface.material.size = 1, surface.depth = 0.1f;
            const Twin twin(surface, shot, method == "error");
            const auto lab = make_lab(find_lab("14"), shot);
            const Image places = render_shot(*lab, shot);
            shot.probe = {"level"};
            const Image levels = render_shot(*lab, shot);
            size_t seen = 0;
            for (size_t i = 0; i < places.values.size(); i += 4) {
                if (places.values[i] == no_surface) continue;
                ++seen;
                const double expected = twin.level(method, size_t(std::lround(places.values[i + 2])));
                ASSERT_NEAR(double(levels.values[i]), expected, 1e-3 * expected)
                    << name << ", " << patches << " patches of " << corners << ", " << method;
            }
            EXPECT_GT(seen, 300u) << name << ", " << method;
        }
}

/// Returns the minimum and maximum of a probe's first channel over the pixels that show a surface.
std::pair<float, float> range_of(const Image& probe) {
    std::pair<float, float> range{no_surface, -no_surface};
    for (size_t i = 0; i < probe.values.size(); i += 4)
        if (probe.values[i] != no_surface)
            range = {std::min(range.first, probe.values[i]), std::max(range.second, probe.values[i])};
    return range;
}

TEST(AdaptiveDisplacement, LevelsStayWithinTheGlRangeFromAnyCamera) {
    // In the middle of a patch, of an edge, and on a vertex; below the ground, far away, and straight from above.
    const std::vector<Orbit> cameras = {{.yaw = 0, .pitch = 0, .distance = 1, .target = {0.5, 0, -0.5}},
                                        {.yaw = 0, .pitch = 0, .distance = 1, .target = {2, 0, 0}},
                                        {.yaw = 0, .pitch = 0, .distance = 1, .target = {0, 0, -1}},
                                        {.yaw = 10, .pitch = -40, .distance = 3},
                                        {.yaw = 10, .pitch = 30, .distance = 500},
                                        {.yaw = 0, .pitch = 89, .distance = 9}};
    for (const char* method : {"distance", "size", "error"}) {
        // From above, all patches are drawn with the levels that they have for the eye.
        Shot shot = shot_of("14",
                            {{"view", "above"},
                             {"patches", "8"},
                             {"map", "fbm"},
                             {"size", "256"},
                             {"method", method},
                             {"farthest", "2"},
                             {"finest", "6"},
                             {"coarsest", "0"},
                             {"segment", "1"},
                             {"budget", "0.125"},
                             {"cull", "none"}},
                            "level", {32, 32});
        const auto lab = make_lab(find_lab("14"), shot);
        for (const char* depth : {"0", "0.3"})
            for (const Orbit& camera : cameras) {
                set_knob(*lab, "depth", depth);
                shot.camera = camera;
                const auto [min, max] = range_of(render_shot(*lab, shot));
                EXPECT_GE(min, 1) << method << " " << camera.pitch;
                EXPECT_LE(max, 64.0001f) << method << " " << camera.pitch;
                if (std::string(depth) == "0" && *method == 'e') {
                    EXPECT_EQ(max, 1) << "nothing can be off";
                }
            }
    }
}

TEST(AdaptiveDisplacement, CullsNearlyAllOfAShallowGlobesBack) {
    // Seen from a distance of 4 radii, a sphere is visible down to a cosine of 1/4. Five eighths of it face away.
    Shot shot = eye({{"surface", "sphere"},
                     {"patches", "32"},
                     {"map", "smooth"},
                     {"size", "256"},
                     {"depth", "0.01"},
                     {"method", "uniform"},
                     {"level", "1"}},
                    "place", {64, 64});
    shot.camera = {.yaw = 20, .pitch = 15, .distance = 4};
    const auto lab = make_lab(find_lab("14"), shot);
    const double all = double(triangles(*lab, shot, "none").size()), left = double(triangles(*lab, shot, "all").size());
    EXPECT_LT(left / all, 0.375 + 0.2) << "culled of the five eighths: " << (1 - left / all) / 0.625;
    EXPECT_GT(left / all, 0.375);
}

TEST(AdaptiveDisplacement, EqualsTheFlatMeshWithoutDepthOrBeyondTheFade) {
    for (const char* surface : {"ground", "box"}) {
        const auto depths = [&](std::vector<Knob> knobs) {
            knobs.insert(knobs.begin(), {{"surface", surface}, {"patches", "6"}, {"map", "fbm"}, {"size", "256"}});
            Shot shot = eye(knobs, "depth");
            shot.camera = {.yaw = 30, .pitch = 25, .distance = 5};
            return drawn("14", shot);
        };
        const Image flat = depths({{"depth", "0"}, {"method", "uniform"}, {"level", "1"}});
        for (const auto& knobs : std::vector<std::vector<Knob>>{
                 {{"depth", "0"}, {"method", "distance"}},
                 {{"depth", "0"}, {"method", "error"}},
                 {{"fade", "true"}, {"fade_begin", "0"}, {"fade_end", "0.5"}, {"method", "size"}},
                 {{"fade", "true"}, {"fade_begin", "0.5"}, {"fade_end", "0"}, {"method", "error"}}}) {
            // The tolerance is in metres. The probe stores floats of up to 16.
            EXPECT_EQ(difference(depths(knobs), flat, 2e-5).pixels_over, 0u) << surface << " " << knobs[0].second;
        }
        EXPECT_GT(difference(depths({{"method", "size"}}), flat, 1e-3).pixels_over, 1000u);
    }
}

// Labs 13, 14 and 17, with the knobs that make the most triangles.
TEST(Displacement, BoundsItsTrianglesAtExtremeKnobs) {
    const std::vector<std::pair<const char*, std::vector<Knob>>> ends = {
        {"13", {{"view", "one"}, {"surface", "globe"}, {"patches", "32"}, {"level", "64"}}},
        {"13", {{"view", "spacings"}, {"surface", "sphere"}, {"patches", "32"}, {"level", "64"}, {"show", "wire"}}},
        {"14", {{"surface", "globe"}, {"patches", "128"}, {"repeat", "8"}, {"budget", "0.125"}, {"depth", "0.5"}}},
        {"14", {{"surface", "torus"}, {"patches", "128"}, {"method", "uniform"}, {"level", "64"}, {"cull", "none"}}},
        {"14", {{"method", "size"}, {"segment", "1"}, {"cull", "none"}, {"wire", "on"}, {"levels_of", "patch"}}},
        {"14", {{"method", "distance"}, {"nearest", "32"}, {"farthest", "64"}, {"finest", "6"}, {"corners", "3"}}},
        {"17",
         {{"budget", "0.25"}, {"method", "displacement"}, {"map", "posts"}, {"depth", "0.25"}, {"view", "picture"}}}};
    for (const auto& [lab, set] : ends) {
        const Shot shot = shot_of(lab, set, "", {117, 77});
        const measure::BenchSubject subject = measure::drawn(std::shared_ptr<Lab>(make_lab(find_lab(lab), shot)), shot);
        const auto triangles = std::find_if(subject.work.begin(), subject.work.end(),
                                            [](const auto& one) { return one.first == "triangles"; });
        ASSERT_NE(triangles, subject.work.end());
        EXPECT_GT(triangles->second, 1e5) << lab;
        // A fractional level rounds up by up to two segments: at level 8, half as many triangles more. The lab's own
        // count adds a coarse draw.
        EXPECT_LT(triangles->second, 1.6 * DisplacedSurface::most_triangles) << lab << " " << set[1].second;
    }
}

TEST(AdaptiveDisplacement, AMipLevelByPatchOpensCracksOnlyWhereLevelsDiffer) {
    const auto holes = [](const char* method, const char* mip) {
        Shot shot = eye({{"surface", "torus"},
                         {"patches", "5"},
                         {"map", "stones"},
                         {"size", "256"},
                         {"method", method},
                         {"nearest", "2.6"},
                         {"farthest", "4.2"},
                         {"mip", mip}},
                        "winding", {256, 256});
        shot.camera = {.yaw = 25, .pitch = 35, .distance = 4};
        return holes_of(drawn("14", shot));
    };
    EXPECT_EQ(holes("distance", "base"), 0u);
    EXPECT_EQ(holes("uniform", "patch"), 0u);
    EXPECT_GT(holes("distance", "patch"), 300u);
}

TEST(AdaptiveDisplacement, AMipLevelByPatchChangesTheSurfaceOnlyAtCoarseLevels) {
    const auto depth = [](const char* level, const char* mip) {
        return drawn("14", eye({{"method", "uniform"},
                                {"level", level},
                                {"mip", mip},
                                {"size", "256"},
                                {"map", "stones"},
                                {"patches", "4"}},
                               "depth"));
    };
    const auto moved = [&](const char* level) {
        return summarize(error_image(depth(level, "patch"), depth(level, "base"), ErrorMetric::absolute)).largest;
    };
    EXPECT_GT(moved("2"), 0.1);  // metres; a vertex stands for 32 texels
    EXPECT_EQ(moved("64"), 0);   // 256 texels, 4 patches: a texel a segment
}

/// The number of pixels of a picture in the evening that a kind of shadow changes from the other.
size_t changed_by_shadows(const char* cull, const char* first, const char* second, const char* depth = "0.1") {
    const auto drawn_with = [&](const char* shadow) {
        Shot shot =
            eye({{"cull", cull}, {"shadow", shadow}, {"depth", depth}, {"light_yaw", "-30"}, {"light_pitch", "8"}}, "",
                {192, 128});
        shot.camera = {.yaw = 25, .pitch = 12, .distance = 2, .target = {0, 0, 0}, .field_of_view = 25};
        return drawn("14", shot);
    };
    return difference(drawn_with(first), drawn_with(second), 8.0 / 255).pixels_over;
}

TEST(AdaptiveDisplacement, CulledPatchesCastAShadowUnlessOnlyDrawnOnesDo) {
    EXPECT_GT(changed_by_shadows("all", "none", "all"), 1000u);
    EXPECT_GT(changed_by_shadows("all", "all", "drawn"), 200u);
    EXPECT_EQ(changed_by_shadows("none", "all", "drawn"), 0u) << "nothing is culled";
}

TEST(AdaptiveDisplacement, AFlatGroundCastsNoShadow) { EXPECT_EQ(changed_by_shadows("all", "none", "all", "0"), 0u); }

/// Far hills whose displacement is gone, towards a low sun.
Shot faded_hills(const char* lost_slopes, const char* probe, const char* depth = "0.1") {
    Shot shot = eye({{"patches", "24"},
                     {"method", "size"},
                     {"repeat", "4"},
                     {"size", "256"},
                     {"depth", depth},
                     {"fade", "on"},
                     {"fade_begin", "0"},
                     {"fade_end", "1"},
                     {"shininess", "60"},
                     {"light_yaw", "-150"},
                     {"light_pitch", "20"},
                     {"lost_slopes", lost_slopes}},
                    probe, {32, 24});
    shot.camera = {.yaw = 30, .pitch = 20, .distance = 30, .target = {0, 0, 0}, .field_of_view = 30};
    return shot;
}

TEST(AdaptiveDisplacement, LeadrComesNearerToAllOfTheDisplacement) {
    for (const char* probe : {"normal", "highlight"}) {
        const double without = error_of("14", faded_hills("none", probe)).mean,
                     with = error_of("14", faded_hills("leadr", probe)).mean;
        EXPECT_LT(with, (probe == std::string("normal") ? 0.6 : 0.15) * without) << probe << " " << without;
    }
}

TEST(AdaptiveDisplacement, AHighlightOfAPlaneHasNothingToWiden) {
    // On a plane all slopes are 0. A Beckmann lobe with alpha² = 2 / (shininess + 2) then falls with the slope h.xz /
    // h.y of the direction h halfway between eye and light.
    for (const char* lost_slopes : {"none", "leadr"}) {
        const Shot shot = faded_hills(lost_slopes, "highlight", "0");
        const Image drawn_ = drawn("14", shot), up = drawn("14", faded_hills(lost_slopes, "normal", "0"));
        const Frame frame{0, shot.size, 0, Camera(shot.camera, double(shot.size.x) / shot.size.y), {}};
        const double yaw = glm::radians(-150.0), pitch = glm::radians(20.0);
        const glm::dvec3 to_light(std::sin(yaw) * std::cos(pitch), std::sin(pitch), std::cos(yaw) * std::cos(pitch));
        int compared = 0;
        double brightest = 0;
        for (int y = 0; y < shot.size.y; ++y)
            for (int x = 0; x < shot.size.x; ++x) {
                const float share = *drawn_.pixel(x, y);
                if (share == no_surface) continue;
                const glm::dvec3 halfway = to_light - frame.ray(x, y).direction;
                const double slope = std::hypot(halfway.x, halfway.z) / halfway.y;
                EXPECT_NEAR(double(share), std::exp(-62 * slope * slope / 2), 0.01) << x << "," << y;
                EXPECT_NEAR(double(up.pixel(x, y)[1]), 1, 1e-4) << "8 bits hold no 0";
                brightest = std::max(brightest, double(share)), ++compared;
            }
        EXPECT_GT(compared, 100);
        EXPECT_GT(brightest, 0.9) << "the picture has the middle of the lobe";
    }
}

}  // namespace
}  // namespace relief
