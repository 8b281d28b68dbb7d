// Lab 12: the exact hit is exact on every map and from every side. So are the values that depend on it.
#include <fmt/format.h>

#include <random>

#include "framework/library/maps/skips.h"
#include "framework/library/maps/test_maps.h"
#include "framework/staff/reference/height_field.h"
#include "framework/staff/reference/terminator.h"
#include "labs/12_relief_exact/relaxed_cones.h"
#include "tests/core/gl/glsl_function.h"
#include "tests/labs/shots.h"

namespace relief {
namespace {

constexpr const char* hit_methods[] = {"walk", "coarse", "windows", "max-mips", "cones"};

std::vector<Knob> alone(std::vector<Knob> knobs) {
    knobs.insert(knobs.begin(), {{"view", "one"}, {"shadow", "none"}, {"outline", "off"}, {"extent", "4"}});
    return knobs;
}
Shot seen(std::vector<Knob> knobs, double yaw, double pitch, const char* probe = "uv", glm::ivec2 size = {128, 128}) {
    Shot shot = shot_of("12", alone(std::move(knobs)), probe, size);
    shot.camera = {.yaw = yaw, .pitch = pitch, .distance = 0.4, .target = {0.13, 0.07, 0}, .field_of_view = 40};
    return shot;
}

struct Tally {
    size_t pixels = 0, off = 0;  ///< off: by more than 0.05 texels
    void add(const Image& error) {
        for (const float value : error.values)
            if (std::isfinite(value)) ++pixels, off += value > 0.05f;
    }
    double share() const { return double(off) / double(std::max<size_t>(1, pixels)); }
};

/// Only the pixels whose rays come in at 89 degrees from the wall's normal or steeper.
Image up_to_89_degrees(Image error, const Shot& shot) {
    const Frame frame{0, shot.size, 0, Camera(shot.camera, double(shot.size.x) / shot.size.y), {}};
    for (int y = 0; y < error.height; ++y)
        for (int x = 0; x < error.width; ++x)
            if (-frame.ray(x, y).direction.z < std::cos(glm::radians(89.0))) *error.pixel(x, y) = no_surface;
    return error;
}

// Each sees 20 degrees around its own angle: together 0 to 89.
constexpr std::pair<double, double> sides[] = {{0, 0}, {25, -35}, {-60, 10}, {75, -5}};

TEST(ReliefExact, AtMostOneRayInTenThousandMissesByATwentiethOfATexel) {
    for (const char* map : {"smooth", "fbm", "bricks", "stones", "posts", "rock", "wall", "paving"})
        for (const char* bits : {"float", "8"}) {
            Tally tally;
            for (const char* size : {"512", "1024"}) {
                const Shot first = seen({{"map", map}, {"bits", bits}, {"size", size}, {"method", "windows"}}, 0, 0);
                const auto lab = make_lab(find_lab("12"), first);
                for (const auto& [yaw, pitch] : sides) {
                    Shot shot = first;
                    shot.camera.yaw = yaw, shot.camera.pitch = pitch;
                    tally.add(up_to_89_degrees(
                        error_image(render_shot(*lab, shot), truth_of(*lab, shot), ErrorMetric::distance), shot));
                }
            }
            EXPECT_GT(tally.pixels, 100'000u);
            EXPECT_LE(tally.share(), 1e-4) << map << ", " << bits << ": " << tally.off << " of " << tally.pixels;
        }
}

TEST(ReliefExact, IsExactToATenthOfATexelOnTheLargestWalls) {
    struct End {
        std::vector<Knob> knobs;
        int pixels;
    };
    // The largest map takes seconds to generate, and a tenth of a second for each exact ray.
    const End ends[] = {{{{"size", "512"}}, 64},
                        {{{"size", "512"}, {"repeat", "8"}, {"mirror", "on"}}, 64},
                        {{{"size", "512"}, {"repeat", "8"}, {"stretch", "0.25"}}, 48},
                        {{{"size", "512"}, {"repeat", "8"}, {"stretch", "4"}}, 64},
                        {{{"size", "4096"}, {"repeat", "8"}}, 24}};
    for (const auto& [knobs, pixels] : ends)
        for (const double yaw : {60.0, 84.0, -88.0}) {
            Shot shot = shot_of("12", {{"view", "one"}, {"map", "posts"}, {"depth", "1"}, {"extent", "64"}}, "uv",
                                {pixels, pixels});
            shot.set.insert(shot.set.end(), knobs.begin(), knobs.end());
            shot.camera = {.yaw = yaw, .pitch = 0, .distance = 5};
            const auto lab = make_lab(find_lab("12"), shot);
            const ErrorSummary error = summarize(up_to_89_degrees(
                error_image(render_shot(*lab, shot), truth_of(*lab, shot), ErrorMetric::distance), shot));
            EXPECT_GT(error.count, size_t(pixels) * size_t(pixels) / 4);
            EXPECT_LE(error.p99, 0.1) << knobs.back().first << " at " << yaw << " degrees";
        }
}

// At a tile's border the place in the tile jumps by a whole tile, and rounding chooses the side.
TEST(ReliefExact, APlaceInATileDiffersByWholeTilesAtABorder) {
    Shot shot =
        shot_of("12", {{"view", "one"}, {"surface", "urn"}, {"depth", "0"}, {"repeat", "8"}}, "ray", {640, 480});
    shot.camera = {.yaw = 111, .pitch = -80, .distance = 1275, .target = {}, .field_of_view = 1};
    const auto lab = make_lab(find_lab("12"), shot);
    const Image rays = render_shot(*lab, shot), exact = truth_of(*lab, shot);
    size_t pixels = 0;
    for (size_t i = 0; i < rays.pixel_count(); ++i)
        for (const size_t channel : {i * 4 + 2, i * 4 + 3}) {
            const double off = double(rays.values[channel]) - double(exact.values[channel]);
            if (!std::isfinite(off)) continue;
            ++pixels;
            EXPECT_NEAR(off, 512 * std::round(off / 512), 0.2);
        }
    EXPECT_GT(pixels, 500u);
}

TEST(ReliefExact, IsExactMirroredStretchedRepeatedAndOnAnySurface) {
    const std::vector<std::vector<Knob>> lays = {{{"mirror", "on"}},
                                                 {{"stretch", "2.5"}},
                                                 {{"stretch", "0.4"}, {"mirror", "on"}, {"repeat", "2"}},
                                                 {{"map", "posts"}, {"depth", "0.3"}},
                                                 {{"map", "rock"}},
                                                 {{"surface", "column"}},
                                                 {{"surface", "column"}, {"outline", "on"}, {"depth", "0.2"}},
                                                 {{"surface", "column"}, {"mirror", "on"}, {"stretch", "2"}}};
    for (const char* method : hit_methods) {
        Tally tally;
        for (std::vector<Knob> lay : lays) {
            const bool column = lay[0].second == "column";
            lay.insert(lay.begin(), {{"map", "stones"}, {"method", method}});
            Shot shot = seen(lay, 35, 15);
            if (column) shot.camera.distance = 1.2;
            const auto lab = make_lab(find_lab("12"), shot);
            const Image error = error_image(render_shot(*lab, shot), truth_of(*lab, shot), ErrorMetric::distance);
            tally.add(error);
        }
        EXPECT_LE(tally.share(), 2e-4) << method << ": " << tally.off << " of " << tally.pixels;
    }
}

TEST(ReliefExact, IsExactOnAnUrnForRaysSteeperThanADegree) {
    // Flatter, a float's rounding of the interpolated normal moves the hit by texels: the way is over 57 depths long.
    Shot shot = seen({{"surface", "urn"}, {"map", "stones"}, {"method", "windows"}}, 20, 10, "uv", {192, 192});
    shot.camera.distance = 3.2, shot.camera.target = {};
    const auto lab = make_lab(find_lab("12"), shot);
    const Image error = error_image(render_shot(*lab, shot), truth_of(*lab, shot), ErrorMetric::distance);
    Shot base = shot;  // how far in a ray goes at most, from a relief that is 0 everywhere
    base.set.emplace_back("map", "low"), base.probe = {"depth"};
    const Image ground = drawn("12", base);
    base.set.emplace_back("map", "high");
    const Image top = drawn("12", base);
    Tally tally;
    for (size_t i = 0; i < error.values.size(); ++i) {
        const double way = double(ground.values[i * 4]) - double(top.values[i * 4]);
        const double metres = 0.08 * 3.2 / 3;  // of depth: a third of the way around is a tile
        if (std::isfinite(error.values[i]) && way > metres * 0.99 && way < metres * 57)
            ++tally.pixels, tally.off += error.values[i] > 0.05f;
    }
    EXPECT_GT(tally.pixels, 5000u);
    EXPECT_LE(tally.share(), 2e-4) << tally.off << " of " << tally.pixels;
}

double mean_turns(const char* method, const char* map, double yaw, const char* size = "512") {
    const Image steps = drawn("12", seen({{"map", map}, {"method", method}, {"size", size}}, yaw, 3, "steps"));
    double sum = 0, count = 0;
    for (size_t i = 0; i < steps.values.size(); i += 4)
        if (std::isfinite(steps.values[i])) sum += double(steps.values[i]), ++count;
    return sum / count;
}

TEST(ReliefExact, WindowsHalveTheIterationsOnMapsTheyWereNotTunedFor) {
    for (const char* size : {"512", "1024"})
        for (const char* map : {"smooth", "fbm", "rock", "wall", "paving", "stones", "posts"})
            for (const double yaw : {40.0, 75.0}) {
                const double walked = mean_turns("walk", map, yaw, size);
                EXPECT_LT(mean_turns("windows", map, yaw, size), std::max(4.0, 0.5 * walked))
                    << map << ", " << yaw << ", " << size << ": walked " << walked;
            }
}

TEST(ReliefExact, SkipsTheMarchOnEmptyMapsAndBackFaces) {
    for (const char* method : hit_methods) {
        EXPECT_LE(mean_turns(method, "low", 70), 1.01) << method;
        EXPECT_LE(mean_turns(method, "plateau", 70), 6) << method << ": it begins at the height of the highest";
        const Image behind = drawn("12", seen({{"map", "stones"}, {"method", method}}, 180, 10, "steps"));
        for (size_t i = 0; i < behind.values.size(); i += 4) ASSERT_EQ(behind.values[i], 0) << method;
    }
}

TEST(ReliefExact, ABallAndThreeReliefsIntersectWhereTheExactSurfacesDo) {
    for (const double yaw : {14.0, -35.0, 60.0}) {
        Shot shot = shot_of("12", {}, "depth", {256, 192});
        shot.camera.yaw = yaw;
        const auto lab = make_lab(find_lab("12"), shot);
        const Image depth = render_shot(*lab, shot), truth = truth_of(*lab, shot);
        size_t off = 0, outline = 0;
        for (size_t i = 0; i < depth.values.size(); i += 4) {
            const bool here = std::isfinite(depth.values[i]), there = std::isfinite(truth.values[i]);
            outline += here != there;
            off += here && there && std::abs(depth.values[i] - truth.values[i]) > 0.005;
        }
        // Outlines that fall within a rounding of a pixel's centre; the ball is a mesh of flat pieces.
        EXPECT_LE(off, depth.pixel_count() / 500) << yaw;
        EXPECT_LE(outline, depth.pixel_count() / 1000) << yaw;
    }
}

TEST(ReliefExact, ItsShadowHasTheShapeOfTheRelief) {
    for (const char* map : {"stones", "bricks", "rock"})
        for (const auto& [yaw, pitch] : {std::pair("60", "20"), {"-120", "45"}, {"10", "-5"}}) {
            Shot shot = seen({{"map", map}, {"light_yaw", yaw}, {"light_pitch", pitch}}, 25, 20, "shadow");
            const auto lab = make_lab(find_lab("12"), shot);
            const ErrorSummary error =
                summarize(error_image(render_shot(*lab, shot), truth_of(*lab, shot), ErrorMetric::absolute));
            EXPECT_LT(error.mean, 0.01) << map << ", " << yaw << ", " << pitch;
        }
}

/// A normal of the base, a normal of the map and a direction to the light.
using Guess = std::array<glm::vec3, 3>;

/// Returns the largest error of the shader's Chiang factor against the reference.
double chiang_error(const std::vector<Guess>& guesses, const PlantedMistake& mistake = {}) {
    std::vector<GlslInput> inputs;
    for (const auto& [surface, mapped, light] : guesses)
        inputs.push_back({glm::vec4(surface, 0), glm::vec4(mapped, 0), glm::vec4(light, 0)});
    const std::vector<glm::vec4> drawn =
        evaluate_glsl("common/terminator.glsl", "vec4(chiang_shadow(a.xyz, b.xyz, c.xyz))", inputs, mistake);
    double largest = 0;
    for (size_t i = 0; i < guesses.size(); ++i) {
        const double exact = chiang_shadow(guesses[i][0], guesses[i][1], guesses[i][2]);
        const double off = std::abs(double(drawn[i].x) - exact);
        largest = std::isfinite(off) ? std::max(largest, off) : HUGE_VAL;  // max() would drop NaN
    }
    return largest;
}

TEST(ReliefExact, TheChiangFactorEqualsItsTwinInDoublePrecisionAtItsEnds) {
    const glm::vec3 up(0, 0, 1), side(1, 0, 0), across(0, 1, 0), low = glm::normalize(glm::vec3(1, 0, 0.25f));
    const glm::vec3 leaning(0.6f, 0, 0.8f), away(-0.8f, 0, 0.6f);
    const glm::vec3 horizon(1, 0, 1e-7f);
    const std::vector<Guess> ends = {
        {up, side, up}, {up, across, low},   {up, away, leaning},                     // n . L = 0
        {up, up, side}, {up, leaning, side}, {up, side, side},    {up, up, horizon},  // Ng . L
        {up, up, low},  {up, up, up},        {low, low, side},                        // equal normals
        {up, up, -up},  {up, leaning, -up},  {up, -leaning, low}, {up, away, side}};  // below
    for (const Guess& end : ends)
        EXPECT_LT(chiang_error({end}), 1e-6) << fmt::format("{} {}, {} {}", end[1].x, end[1].z, end[2].x, end[2].z);
    for (const float slope : {1e3f, 1e6f, 1e18f}) {
        const glm::vec3 steep = glm::normalize(glm::vec3(slope, 0, 1));
        EXPECT_LT(chiang_error({{up, steep, low}, {up, steep, away}, {up, steep, up}}), 1e-6) << slope;
    }

    EXPECT_GT(chiang_error(ends, {"dot(surface, mapped), 1e-6)", "dot(surface, mapped), 1e-30)"}), 0.1)
        << "a lower bound that is too small";
}

TEST(ReliefExact, TurningCameraAndLightWithTheColumnChangesNothing) {
    // Three tiles go around it: a third of a turn takes it to itself.
    const auto picture = [](double yaw, const char* light_yaw) {
        Shot shot = shot_of("12", {{"view", "one"}, {"surface", "column"}, {"map", "stones"}, {"light_yaw", light_yaw}},
                            "", {160, 160});
        shot.camera = {.yaw = yaw, .pitch = 12, .distance = 2.4};
        return drawn("12", shot);
    };
    const Image here = picture(10, "40"), there = picture(130, "160");
    // A rounding away, a ray grazes the next stone and an edge is in the shadow: a pixel in a thousand.
    EXPECT_LE(difference(here, there, 8.0 / 255).pixels_over, here.pixel_count() / 500);
    EXPECT_GT(difference(here, picture(130, "40"), 8.0 / 255).pixels_over, here.pixel_count() / 10)
        << "the light stays";
}

TEST(ReliefExact, ADepthOfZeroIsThePlainWall) {
    const auto picture = [](const char* map, const char* depth) {
        return drawn("12", seen({{"map", map}, {"depth", depth}}, 40, 20, "uv"));
    };
    const Image flat = picture("high", "0.08");
    const Image stones = picture("stones", "0");
    EXPECT_LT(difference(flat, stones, 0).largest, 1e-3);
}

TEST(ReliefExact, AShiftOfWholeTilesOnlyShiftsEveryHit) {
    const Image here = drawn("12", seen({{"map", "rock"}}, 55, 15));
    for (const int shift : {1, 3, 10000}) {
        Image there = drawn("12", seen({{"map", "rock"}, {"shift", std::to_string(shift)}}, 55, 15));
        for (size_t i = 0; i < there.values.size(); i += 4)
            for (size_t c : {0, 1}) there.values[i + c] -= float(shift % 4 * 512);
        Tally tally;
        tally.add(error_image(there, here, ErrorMetric::distance));
        EXPECT_LE(tally.off, shift % 4 == 0 ? 0u : 8u) << shift;
    }
}

// ---- relaxed cones

/// Returns a map of `side` x `side` texels that is 1 from column `first` to column `last`, else 0.
Image wall_map(int side, int first, int last) {
    Image map(side, side, 1);
    for (int y = 0; y < side; ++y)
        for (int x = first; x <= last; ++x) *map.pixel(x, y) = 1;
    return map;
}

TEST(RelaxedCones, ReachThroughAWallToItsFarSide) {
    // From column 8 the wall begins at column 32 and falls behind column 47. A safe cone ends at 32, 24 texels away.
    // The other way around, the wall's far side is 40 texels away, too: 8 + 64 - 32.
    const Image map = wall_map(64, 32, 47);
    const Image relaxed = exact::relaxed_cone_map(map), safe = cone_map(map);
    EXPECT_LE(*safe.pixel(8, 20), 24);
    EXPECT_GE(*relaxed.pixel(8, 20), 31.9f) << "what is known ends half a tile away";
    // From column 22 the far side is 25 texels away, the near one 10.
    EXPECT_NEAR(*relaxed.pixel(22, 20), 25, 0.01);
    EXPECT_LE(*safe.pixel(22, 20), 10);
    EXPECT_EQ(*relaxed.pixel(40, 20), cone_widest) << "nothing is higher than the wall";
}

TEST(RelaxedCones, LetARayFromAboveItsTexelCrossTheSurfaceAtMostOnce) {
    std::mt19937 random(69);
    std::uniform_real_distribution<double> share(0, 1);
    for (const HeightMap kind : {HeightMap::fbm, HeightMap::bricks, HeightMap::stones}) {
        const Image map = make_height_map(kind, 128), cones = exact::relaxed_cone_map(map);
        const HeightField field(map, true);
        int rays = 0, twice = 0;
        for (int i = 0; i < 4000; ++i) {
            const int x = int(128 * share(random)), y = int(128 * share(random));
            const double foot = double(*map.pixel(x, 127 - y)), cone = double(*cones.pixel(x, 127 - y)),
                         angle = 2 * M_PI * share(random), slant = cone * share(random);
            // From height 1 above the texel, down to the cone's wall.
            int crossings = 0;
            bool is_inside = false;
            for (double r = 0.25; r < 64; r += 0.25) {
                const double height = 1 - r / std::max(slant, 1e-9);
                if (height < foot || r > cone * (height - foot)) break;
                const bool is_below = height < field.height({x + r * std::cos(angle), y + r * std::sin(angle)}) - 1e-6;
                crossings += is_inside && !is_below;
                is_inside = is_below;
            }
            ++rays, twice += crossings > 0;
        }
        // The map looks along 32 directions, so a ray between two of them may leave the surface.
        EXPECT_LT(twice, rays / 50) << int(kind);
    }
}

TEST(ReliefExact, RelaxedConesAreWrongWhereTheExactMethodsAreNot) {
    for (const char* map : {"bricks", "posts"}) {
        const auto wrong = [&](const char* method) {
            const Shot shot = seen({{"map", map}, {"method", method}}, 70, 0);
            const auto lab = make_lab(find_lab("12"), shot);
            const Image errors = error_image(render_shot(*lab, shot), truth_of(*lab, shot), ErrorMetric::distance);
            const auto far_off = std::count_if(errors.values.begin(), errors.values.end(),
                                               [](float error) { return std::isfinite(error) && error > 1; });
            return double(far_off) / double(errors.pixel_count());
        };
        EXPECT_GT(wrong("relaxed"), 0.002) << map;
        EXPECT_LT(wrong("windows"), 0.0002) << map;
    }
    // 15 steps and 8 bisections, and the first read.
    const Image steps = drawn("12", seen({{"map", "posts"}, {"method", "relaxed"}}, 70, 0, "steps"));
    for (size_t i = 0; i < steps.values.size(); i += 4)
        if (steps.values[i] != no_surface) {
            ASSERT_LE(steps.values[i], 24);
        }
}

TEST(ReliefExact, EveryPixelIsFiniteAndNoLoopRunsOn) {
    const std::vector<std::vector<Knob>> scenes = {
        {{"map", "low"}},     {{"map", "high"}},       {{"map", "plateau"}},
        {{"map", "damaged"}}, {{"size", "1"}},         {{"depth", "0"}},
        {{"depth", "1"}},     {{"shift", "10000"}},    {{"stretch", "4"}},
        {{"surface", "urn"}}, {{"surface", "column"}}, {{"surface", "column"}, {"outline", "on"}, {"depth", "1"}}};
    for (const char* method : {"windows", "cones", "relaxed"})
        for (std::vector<Knob> scene : scenes) {
            scene.insert(scene.begin(), {{"map", "posts"}, {"method", method}});
            const auto lab = make_lab(find_lab("12"), seen(scene, 0, 0));
            for (const double yaw : {0.0, 89.9, 90.0, 90.1}) {
                Shot shot = seen(scene, yaw, yaw == 0 ? 0 : 0.05, "steps", {32, 32});
                if (scene.back().first == "surface" || scene[2].first == "surface") shot.camera.distance = 3;
                const Target probe(TargetKind::probe, shot.size), light(TargetKind::light, shot.size);
                draw_lab(*lab, frame_of(shot, probe));
                for (const Image steps = probe.read(); const float value : steps.values)
                    ASSERT_TRUE(value == no_surface || (value >= 0 && value <= 65001));
                shot.probe = {};
                draw_lab(*lab, frame_of(shot, light));
                for (const Image picture = light.read(); const float value : picture.values)
                    ASSERT_TRUE(std::isfinite(value)) << method << ", " << scene[2].first << " = " << scene[2].second;
            }
        }
}

TEST(ReliefExact, IsFiniteInsideTheReliefAndExactOnAMapOf4096Texels) {
    Shot inside = seen({{"map", "stones"}}, 150, 10, "uv", {64, 64});
    inside.camera.distance = 0.02, inside.camera.target = {0, 0, -0.03};
    EXPECT_NO_THROW(drawn("12", inside));
    const Shot large = seen({{"map", "posts"}, {"size", "4096"}, {"method", "windows"}}, 60, 10, "uv", {64, 64});
    const auto lab = make_lab(find_lab("12"), large);
    Tally tally;
    tally.add(error_image(render_shot(*lab, large), truth_of(*lab, large), ErrorMetric::distance));
    EXPECT_LE(tally.off, 20u) << "a float resolves five hundredths of such a texel";
}

TEST(ReliefExact, NoRayOfAUsualPictureReachesTheIterationLimit) {
    for (const char* map : {"posts", "rock", "paving"})
        for (const double yaw : {0.0, 40.0, 65.0}) {
            const Image steps = drawn("12", seen({{"map", map}}, yaw, 5, "steps"));
            for (size_t i = 0; i < steps.values.size(); i += 4)
                ASSERT_TRUE(steps.values[i] == no_surface || steps.values[i + 1] == 0) << map << ", " << yaw;
        }
}

/// How many of a picture's rays had no turns left.
size_t stopped(const Shot& shot) {
    const Image steps = drawn("12", shot);
    size_t count = 0;
    for (size_t i = 0; i < steps.values.size(); i += 4)
        count += std::isfinite(steps.values[i]) && steps.values[i + 1] > 0;
    return count;
}

TEST(ReliefExact, AtExtremeKnobsNoRayStallsAndWindowsReachNoLimit) {
    struct End {
        std::vector<Knob> knobs;
        double yaw;
    };
    // With a constant added to t, 3, 10 and 11 % of the pixels of the first three views were wrong. With rays from
    // interpolated positions, 0.02 to 1.4 % were.
    const End ends[] = {
        {{{"size", "256"}, {"depth", "1"}, {"extent", "3"}}, 86},
        {{{"size", "256"}, {"depth", "1"}, {"extent", "64"}}, 86},
        {{{"size", "256"}, {"depth", "1"}, {"extent", "3"}}, 89},
        {{{"size", "256"}, {"depth", "1"}, {"extent", "3"}, {"mirror", "on"}, {"stretch", "0.25"}}, -86},
        {{{"size", "4096"}, {"depth", "0.08"}, {"extent", "3"}}, 84}};
    for (const End& end : ends)
        for (const char* method : hit_methods) {
            if (end.knobs[0].second == "4096" && method[0] != 'w') continue;  // seconds to make their maps
            std::vector<Knob> knobs = end.knobs;
            knobs.insert(knobs.end(), {{"map", "posts"}, {"method", method}});
            Shot shot = seen(knobs, end.yaw, 0, "uv", {96, 96});
            shot.camera.distance = 1.5, shot.camera.field_of_view = 25, shot.camera.target = {};
            const auto lab = make_lab(find_lab("12"), shot);
            Tally tally;
            tally.add(error_image(render_shot(*lab, shot), truth_of(*lab, shot), ErrorMetric::distance));
            // One or two of 5000 rays graze an edge, and the rounding of t to a float moves them over it.
            EXPECT_LE(tally.share(), 0.0005) << method << ", " << end.yaw << ", " << knobs[0].second;
        }
    for (const auto& [yaw, stretch] : {std::pair(84.0, "1"), {89.5, "0.25"}, {89.9, "4"}}) {
        Shot shot = seen({{"map", "posts"}, {"size", "4096"}, {"depth", "1"}, {"stretch", stretch}, {"extent", "64"}},
                         yaw, 0, "steps", {64, 64});
        shot.camera.distance = 1.5, shot.camera.field_of_view = 25, shot.camera.target = {};
        EXPECT_EQ(stopped(shot), 0u) << yaw;
    }
}

TEST(ReliefExact, AMethodsMapIsMadeOnlyForThatMethod) {
    const auto bytes = [](const char* method) {
        return work_of("12", seen({{"map", "stones"}, {"method", method}}, 40, 10)).texture_bytes;
    };
    constexpr int64_t heights = (512 * 512 * 4 - 1) / 3 + 1;  // floats, with their smaller levels
    EXPECT_NEAR(double(bytes("walk")), double(heights) * 4, 64) << "no albedo, no normals: the probe reads none";
    EXPECT_EQ(bytes("windows") - bytes("walk"), 8 * 256 * 256 * 4);
    EXPECT_EQ(bytes("coarse") - bytes("walk"), 512 * 512 * 4);
}

}  // namespace
}  // namespace relief
