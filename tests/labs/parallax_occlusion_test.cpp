// Lab 11: the shader's march matches its double-precision twin. Optimisations do not change the picture.
#include "framework/core/base/parallel.h"
#include "framework/library/maps/test_maps.h"
#include "framework/library/mesh/shapes.h"
#include "framework/staff/reference/relief_sight.h"
#include "tests/labs/shots.h"

namespace relief {
namespace {

Shot shot_of_one(std::vector<Knob> knobs, const char* probe = "uv", glm::ivec2 size = {128, 128}) {
    knobs.emplace(knobs.begin(), "view", "one");
    return shot_of("11", std::move(knobs), probe, size);
}

/// The map of the reference's tests (parallax_test.cpp): 256² texels, 20 deep, on a wall that fills the picture from
/// any camera.
const std::vector<Knob> table_map = {{"map", "fbm"}, {"size", "256"}, {"depth", "0.078125"}, {"extent", "64"}};
constexpr double table_depth = 20.0 / 256;

/// Returns a camera whose rays are almost parallel. They hit the wall at `degrees` from its normal, in the direction
/// `around` it. The picture covers about one tile.
Orbit slanted(double degrees, double around) {
    const double slant = glm::radians(degrees), turn = glm::radians(around);
    const glm::dvec3 from(std::sin(slant) * std::cos(turn), std::sin(slant) * std::sin(turn), std::cos(slant));
    return {.yaw = glm::degrees(std::atan2(from.x, from.z)),
            .pitch = glm::degrees(std::asin(from.y)),
            .distance = 30,
            .target = {0.37, 0.21, 0},
            .field_of_view = 2};
}

/// The rays of the lab's frame in double precision: the exact hits, and the hits of `march`.
class Rays {
public:
    Rays(const Shot& shot, HeightMap map, bool is_8_bit, double depth) {
        Image heights = make_height_map(map, 256);
        field_.emplace(is_8_bit ? with_8_bits(heights) : heights, true);
        const Mesh wall = make_quad({.width = 64, .height = 64});
        const ReliefSights sights(wall);
        const ReliefMapping mapping{{64, 64}, {0, 0}, glm::vec2(float(depth)), float(depth), 256};
        const Frame frame{0, shot.size, 0, Camera(shot.camera, double(shot.size.x) / shot.size.y), {}};
        for (int y = 0; y < shot.size.y; ++y)
            for (int x = 0; x < shot.size.x; ++x) {
                const auto sight = sights.look(frame.ray(x, y), mapping, 0);
                if (!sight) throw std::runtime_error("the wall does not fill the picture");
                rays_.push_back(sight->ray);
                exact_.push_back(field_->first_hit(sight->ray.in_texels(), 1).value().texel);
            }
    }

    struct Figures {
        double mean = 0, wrong = 0;  ///< texels; share of pixels off by more than one texel
    };
    /// Returns the error of the hits that `found(i)` gives for pixel i.
    template <class Found>
    Figures figures(const Found& found) const {
        Figures sum;
        for (size_t i = 0; i < exact_.size(); ++i) {
            const double error = glm::distance(exact_[i], glm::dvec2(found(i)));
            sum.mean += error, sum.wrong += error > 1;
        }
        return {sum.mean / double(exact_.size()), sum.wrong / double(exact_.size())};
    }
    Figures of_twin(double steps, Refinement refinement, int rounds) const {
        return figures([&](size_t i) { return march(*field_, rays_[i], steps, refinement, rounds).texel; });
    }
    Figures of(const Image& probe) const {
        return figures([&](size_t i) { return glm::vec2(probe.values[i * 4], probe.values[i * 4 + 1]); });
    }
    size_t count() const { return exact_.size(); }

private:
    std::optional<HeightField> field_;
    std::vector<ReliefRay> rays_;
    std::vector<glm::dvec2> exact_;
};

struct Search {
    double steps;
    Refinement refinement;
    int rounds;
    std::vector<Knob> knobs() const {
        return {{"steps", std::to_string(int(steps))},
                {"refine", refinement_names[size_t(refinement)]},
                {"rounds", std::to_string(rounds)},
                {"skip", "false"}};
    }
};

const std::vector<Search> searches = {
    {8, Refinement::linear, 0},   {16, Refinement::linear, 0},    {32, Refinement::linear, 0},
    {64, Refinement::linear, 0},  {128, Refinement::linear, 0},   {256, Refinement::linear, 0},
    {16, Refinement::none, 0},    {16, Refinement::bisection, 5}, {8, Refinement::secant, 2},
    {4, Refinement::illinois, 4},
};

void expect_like_the_twin(const char* bits) {
    for (const double angle : {60.0, 80.0}) {
        Shot shot = shot_of_one({});
        shot.camera = slanted(angle, 25);
        const Rays rays(shot, HeightMap::fbm, *bits == '8', table_depth);
        // A ray that grazes an edge may fall on different sides in floats and in double precision. That affects at most
        // four of 16,384 rays, which may be off by a quarter of the march. A filter of 8-bit heights returns 8-bit
        // heights again. More rays then pass an edge within one such step (41 at 80 degrees), and the others are off by
        // a quarter of a step.
        const bool is_8_bit = *bits == '8';
        const double reach = 20 * std::tan(glm::radians(angle));
        const double lone = (is_8_bit ? 60 : 4) / double(rays.count());
        const double slack = lone * reach / 4 + (is_8_bit ? reach / 255 / 4 : 0);
        for (const Search& search : searches) {
            shot.set = with(with(shot_of_one({}).set, table_map), with(search.knobs(), {{"bits", bits}}));
            const Rays::Figures gpu = rays.of(drawn("11", shot));
            const Rays::Figures twin = rays.of_twin(search.steps, search.refinement, search.rounds);
            EXPECT_NEAR(gpu.mean, twin.mean, 0.05 * twin.mean + slack)
                << search.steps << " " << refinement_names[size_t(search.refinement)] << " at " << angle;
            EXPECT_NEAR(gpu.wrong, twin.wrong, 0.05 * twin.wrong + lone)
                << search.steps << " " << refinement_names[size_t(search.refinement)] << " at " << angle;
        }
    }
}

TEST(ParallaxOcclusion, MatchesTheErrorsOfItsTwinOnFloatHeights) { expect_like_the_twin("float"); }

TEST(ParallaxOcclusion, MatchesTheErrorsOfItsTwinOn8BitHeights) { expect_like_the_twin("8"); }

double mean_of(const Image& probe) {
    double sum = 0;
    for (size_t i = 0; i < probe.pixel_count(); ++i) sum += double(probe.values[i * 4]);
    return sum / double(probe.pixel_count());
}

TEST(ParallaxOcclusion, SkippingMovesNoHitByHalfATexelAndReadsFewerHeights) {
    struct Scene {
        std::vector<Knob> knobs;
        Orbit camera;
    };
    // The flat tops of bricks; a plateau, where every march has one height; a shallow relief seen from straight ahead.
    const std::vector<Scene> scenes = {
        {{{"map", "bricks"}, {"size", "256"}, {"steps", "64"}}, {.yaw = 40, .pitch = 15, .distance = 0.6}},
        {{{"map", "bricks"}, {"size", "256"}, {"steps", "64"}, {"surface", "column"}},
         {.yaw = 40, .pitch = 15, .distance = 1, .target = {0, 1, 0}}},
        {{{"map", "plateau"}, {"size", "256"}}, {.yaw = 40, .pitch = 15, .distance = 0.6}},
        {{{"map", "fbm"}, {"size", "256"}, {"depth", "0.01"}, {"steps", "128"}},
         {.yaw = 0, .pitch = 0, .distance = 0.6}}};
    for (const Scene& scene : scenes) {
        const auto probe = [&](const char* name, const char* skip) {
            Shot shot = shot_of_one(with(scene.knobs, {{"skip", skip}}), name);
            shot.camera = scene.camera;
            return drawn("11", shot);
        };
        const Difference off = difference(probe("uv", "true"), probe("uv", "false"), 0.5);
        EXPECT_EQ(off.pixels_over, 0u) << scene.knobs[0].second << ": " << off.largest;
        EXPECT_LT(mean_of(probe("steps", "true")), mean_of(probe("steps", "false"))) << scene.knobs[0].second;
    }
}

TEST(ParallaxOcclusion, SkippingOnACoarserLevelMovesNoHitByHalfItsTexel) {
    // From here a texel of that level spans 16 to 32 texels of the map.
    const auto probe = [&](const char* name, const char* skip) {
        Shot shot = shot_of_one({{"map", "stones"},
                                 {"size", "1024"},
                                 {"depth", "0.1"},
                                 {"mip", "footprint"},
                                 {"steps", "64"},
                                 {"skip", skip}},
                                name);
        shot.camera = {.yaw = 10, .pitch = 5, .distance = 2.5};
        return drawn("11", shot);
    };
    EXPECT_EQ(difference(probe("uv", "true"), probe("uv", "false"), 16).pixels_over, 0u);
    EXPECT_LT(mean_of(probe("steps", "true")), 0.98 * mean_of(probe("steps", "false")));
}

TEST(ParallaxOcclusion, WithoutDepthEqualsThePlainPicture) {
    for (const char* surface : {"wall", "column", "urn"}) {
        std::vector<Knob> flat = {{"surface", surface}, {"map", "stones"}, {"size", "256"}, {"depth", "0"}};
        Shot shot = shot_of_one(flat);
        shot.camera = {.yaw = 30, .pitch = 20, .distance = 2.5};
        // The hit is the entry point, up to the rounding of coordinates of some thousand texels.
        EXPECT_LT(error_of("11", shot).largest, 0.02) << surface;
        shot.probe = {};
        const Image plain = drawn("11", shot);
        for (const std::vector<Knob>& search :
             std::vector<std::vector<Knob>>{{{"steps", "1"}},
                                            {{"steps", "4"}, {"skip", "false"}, {"refine", "none"}},
                                            {{"count", "texel"}},
                                            {{"refine", "secant"}}}) {
            shot.set = with(shot_of_one(flat).set, search);
            expect_same_picture(drawn("11", shot), plain, 0, 0);
        }
    }
}

/// Returns the mean distance of two `uv` probes after a shift of the second, and the share of pixels further off than a
/// texel.
std::pair<double, double> apart(const Image& a, const Image& b, glm::vec2 shift, bool in_a_mirror = false) {
    double sum = 0, wrong = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            const float *const p = a.pixel(x, y), *const q = b.pixel(in_a_mirror ? b.width - 1 - x : x, y);
            const double off = double(glm::distance(glm::vec2(p[0], p[1]), glm::vec2(q[0], q[1]) + shift));
            sum += off, wrong += off > 1;
        }
    return {sum / double(a.pixel_count()), wrong / double(a.pixel_count())};
}

const std::vector<Knob> stones_map = {{"map", "stones"}, {"size", "256"}, {"steps", "64"}};

TEST(ParallaxOcclusion, AMirroredReliefIsTheMirrorImage) {
    Shot shot = shot_of_one(stones_map);
    shot.camera = {.yaw = 50, .pitch = 20, .distance = 0.8};
    const Image hits = drawn("11", shot);
    shot.set = with(shot_of_one(stones_map).set, {{"mirror", "true"}});
    shot.camera.yaw = -50;
    // The wall's four tiles run from 0 to 4, and mirrored from 0 to -4. The right end of one maps to the left end of
    // the other.
    const auto [mean, wrong] = apart(hits, drawn("11", shot), {4 * 256.0f, 0}, true);
    EXPECT_LT(mean, 0.02);
    EXPECT_LT(wrong, 0.002);

    const auto picture = [&](const char* mirror, double yaw, const char* light_yaw) {
        Shot lit = shot_of_one(with(stones_map, {{"mirror", mirror}, {"light_yaw", light_yaw}}), "");
        lit.camera = shot.camera, lit.camera.yaw = yaw;
        return drawn("11", lit);
    };
    const Image straight = picture("false", 50, "-30");
    Image turned = picture("true", -50, "30"), mirrored = turned;
    for (int y = 0; y < turned.height; ++y)
        for (int x = 0; x < turned.width; ++x)
            std::copy_n(turned.pixel(turned.width - 1 - x, y), 3, mirrored.pixel(x, y));
    // Mip levels are chosen for quads of 2 x 2 pixels, and the quads are not mirrored.
    expect_same_picture(straight, mirrored, 12, straight.pixel_count() / 50);
}

}  // namespace
}  // namespace relief
