// Lab 15: slopes can be added but normals cannot. Also tests the light of a distant sea, and a sea that runs for years.
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <numeric>

#include "framework/core/image/file.h"
#include "framework/core/image/mips.h"
#include "framework/staff/reference/degrees.h"
#include "labs/15_ocean/waves.h"
#include "tests/labs/shots.h"
#include "tests/support.h"

namespace relief {
namespace {

using ocean::make_maps, ocean::map_texels, ocean::slope_moments, ocean::tile_metres, ocean::waves_of;

/// Returns knobs for a flat sea at mip level 0. `more` overrides them.
std::vector<Knob> near_sea(const std::vector<Knob>& more = {}) {
    return with({{"view", "one"}, {"displace", "false"}, {"level", "0"}}, more);
}

Shot from_above(std::vector<Knob> knobs, const char* probe, glm::ivec2 size = {64, 64}) {
    Shot shot = shot_of("15", std::move(knobs), probe, size);
    shot.camera = {.yaw = 180, .pitch = 60, .distance = 8, .target = {0, 0, 0}};
    return shot;
}

double sum_of(const Image& image) {
    double sum = 0;
    for (size_t i = 0; i < image.values.size(); i += 4)
        if (std::isfinite(image.values[i])) sum += double(image.values[i]);
    return sum;
}

/// Returns the largest difference of the normals' components, of the sea from above, after a move of the eye in metres
/// and of the clock in seconds.
double change_after(double metres, double seconds) {
    Shot shot = from_above(near_sea({{"displace", "false"}}), "normal");
    const Image before = drawn("15", shot);
    shot.camera.target = {float(metres), 0, float(metres)};
    shot.time = seconds;
    const Image after = drawn("15", shot);
    double largest = 0;
    for (size_t i = 0; i < before.values.size(); ++i)
        if (std::isfinite(before.values[i]))
            largest = std::max(largest, std::abs(double(before.values[i]) - double(after.values[i])));
    return largest;
}

TEST(Ocean, RepeatsAfter400MetresAnd128SecondsAndNotAfterOneTile) {
    EXPECT_LT(change_after(400, 0), 0.01) << "4 tiles of 100 metres, 65 of 6.15";
    EXPECT_LT(change_after(0, 128), 1e-6);
    EXPECT_GT(change_after(100, 0), 0.1);
    EXPECT_GT(change_after(6.15, 0), 0.1);
    EXPECT_GT(change_after(0, 64), 0.1);
}

/// The error of a rule that combines two normals: mean error in degrees, and the steepness of its sea relative to the
/// exact one. Each of the two maps is scaled to the root mean square slope `rms`.
struct RuleError {
    double degrees, steepness;
};
template <class Rule>
RuleError error_of_rule(double rms, Rule rule) {
    const std::array maps = {make_maps(0).waves, make_maps(1).waves};
    double degrees = 0, found = 0, right = 0;
    int count = 0;
    for (int y = 0; y < map_texels; y += 3)
        for (int x = 0; x < map_texels; x += 3, ++count) {
            glm::dvec2 s[2];
            for (int map = 0; map < 2; ++map) {
                const glm::dvec3 moments = slope_moments(map);
                const Image& waves = maps[size_t(map)];
                // Samples the two maps at different positions, so that they are uncorrelated.
                const float* at = waves.pixel(map == 0 ? x : (5 * x + 3 * y) % map_texels,
                                              map == 0 ? y : (3 * x + 2 * y) % map_texels);
                s[map] = glm::dvec2(at[0], at[1]) * rms / std::sqrt(moments.x + moments.y);
            }
            const auto normal = [](glm::dvec2 slope) { return glm::normalize(glm::dvec3(-slope, 1)); };
            const glm::dvec3 exact = normal(s[0] + s[1]), got = glm::normalize(rule(normal(s[0]), normal(s[1])));
            degrees += degrees_between(exact, got);
            found += glm::dot(glm::dvec2(got), glm::dvec2(got)) / (got.z * got.z);
            right += glm::dot(s[0] + s[1], s[0] + s[1]);
        }
    return {degrees / count, std::sqrt(found / right)};
}

TEST(Ocean, TheMeanOfNormalsHalvesTheSlope) {
    const auto mean = [](const glm::dvec3& a, const glm::dvec3& b) { return a + b; };
    // Measured by a separate program over random waves: 3.4, 7.3, 10.5 degrees. For the lab's waves, the handout states
    // these values.
    EXPECT_NEAR(error_of_rule(0.1, mean).degrees, 3.5, 0.05);
    EXPECT_NEAR(error_of_rule(0.2, mean).degrees, 6.8, 0.05);
    EXPECT_NEAR(error_of_rule(0.35, mean).degrees, 10.9, 0.05);
    EXPECT_NEAR(error_of_rule(0.2, mean).steepness, 0.49, 0.01);
    const auto slopes = [](const glm::dvec3& a, const glm::dvec3& b) {
        return glm::dvec3(glm::dvec2(a) / a.z + glm::dvec2(b) / b.z, 1);
    };
    EXPECT_LT(error_of_rule(0.35, slopes).degrees, 1e-6);
}

TEST(Ocean, TheWindMakesTheSlopesOfCoxAndMunk) {
    for (const double wind : {3.0, 6.0, 12.0}) {
        const Shot shot = from_above(
            {{"view", "one"}, {"displace", "false"}, {"level", "8"}, {"wind", std::to_string(wind)}}, "sigma", {8, 8});
        const Image sigma = drawn("15", shot);
        EXPECT_NEAR(double(sigma.values[0]) + double(sigma.values[1]), 0.003 + 0.00512 * wind, 1e-5);
    }
}

/// Returns the relative error of the light in the middle of the sun's path on a distant sea. The reference takes 1024
/// samples per pixel in double precision.
double light_off(const char* far_rule, const char* wind) {
    Shot shot = shot_of(
        "15", {{"view", "one"}, {"displace", "false"}, {"far", far_rule}, {"wind", wind}, {"light_pitch", "20"}},
        "glitter", {32, 32});
    shot.camera = {.yaw = 180, .pitch = 20, .distance = 20000, .target = {0, 0, 0}, .field_of_view = 5};
    const auto lab = make_lab(find_lab("15"), shot);
    const double right = sum_of(truth_of(*lab, shot));
    return sum_of(render_shot(*lab, shot)) / right - 1;
}

TEST(Ocean, LeanMatchesTheLightOfAFarSeaAndPlainMipsExceedIt) {
    for (const char* wind : {"4", "8", "14"}) {
        EXPECT_LT(std::abs(light_off("lean", wind)), 0.06) << wind;
        EXPECT_GT(std::abs(light_off("plain", wind)), 4) << wind;
        EXPECT_LT(std::abs(light_off("samples", wind)), 0.02) << wind;
    }
    // Toksvig assumes an isotropic spread, and derives it from the lengths of 8-bit normals.
    EXPECT_GT(std::abs(light_off("toksvig", "8")), 1.5 * std::abs(light_off("lean", "8")));
}

TEST(Ocean, RepeatsBitForBitAfterItsPeriod) {
    const auto at = [](double time) {
        Shot shot = from_above(near_sea(), "height", {24, 24});
        shot.time = time;
        EXPECT_LT(error_of("15", shot).mean, 0.002) << time;
        return drawn("15", shot).values;
    };
    for (const double time : {0.0, 0.375, -17.5, 1e6 + 3.25, 1e9 - 0.125}) EXPECT_EQ(at(time), at(time + 128)) << time;
    EXPECT_NE(at(0), at(1));
    EXPECT_EQ(at(0), at(-128 * 1e5)) << "whole tiles, backwards";
}

TEST(Ocean, AnEyeUnderWaterHasExactValuesWhereItsRaysLeaveTheWater) {
    Shot shot =
        shot_of("15", {{"view", "one"}, {"wind", "0"}, {"waves", "first"}, {"amplitude_1", "1.2"}}, "", {12, 12});
    shot.camera = {.yaw = 180, .pitch = -30, .distance = 12, .target = {0, 3, 0}};  // the eye is 3 metres below
    const auto lab = make_lab(find_lab("15"), shot);
    const auto truth = [&](const char* probe) {
        shot.probe.name = probe;
        return truth_of(*lab, shot);
    };
    const Image heights = truth("height");
    const auto height = [](const glm::dvec3& place) {
        double sum = 0;
        for (const PlaneWave& wave : waves_of(0))
            sum += 1.2 * wave.amplitude *
                   std::cos(2 * glm::pi<double>() * double(0.16f) / tile_metres *
                                glm::dot(glm::dvec2(wave.k), glm::dvec2(place.x, place.z)) +
                            wave.phase);
        return sum;
    };
    const Frame frame = {0, shot.size, 0, Camera(shot.camera, 1), {}};
    ASSERT_LT(frame.camera.eye().y, -2.9);
    int hits = 0;
    for (int y = 0; y < 12; ++y)
        for (int x = 0; x < 12; ++x) {
            // The reference goes along the ray in steps of a millimetre until it is above the waves.
            const Ray ray = frame.ray(x, y);
            double t = 0;
            while (t < 30 && ray.at(t).y < height(ray.at(t))) t += 0.001;
            if (t >= 30) continue;
            ++hits;
            // A step changes the height by at most its own length, since no wave is steeper than 45 degrees.
            EXPECT_NEAR(*heights.pixel(x, y), height(ray.at(t)), 0.001) << x << ", " << y;
        }
    EXPECT_GT(hits, 75);
    for (const char* displaced : {"true", "false"}) {
        set_knob(*lab, "displace", displaced);
        for (const char* probe : {"normal", "slope", "reflection", "fresnel", "sigma", "glitter"})
            for (const float value : truth(probe).values) ASSERT_FALSE(std::isnan(value)) << probe;
    }
}

TEST(Ocean, AWholeSpreadWithoutCovarianceOrWavesIsASingleSlope) {
    // Determinant 0: there are no waves, so only the highlight's own spread is left.
    Shot shot = shot_of("15", near_sea({{"amplitude_1", "0"}, {"amplitude_2", "0"}, {"shininess", "4096"}}), "glitter",
                        {32, 32});
    shot.set.emplace_back("light_pitch", "20");
    shot.camera = {.yaw = 180, .pitch = 20, .distance = 10, .target = {0, 0, 0}, .field_of_view = 4};
    const Image light = drawn("15", shot);
    float most = 0;
    for (size_t i = 0; i < light.values.size(); i += 4) most = std::max(most, light.values[i]);
    EXPECT_GT(most, 0.9f);
    EXPECT_LE(most, 1.0f);
}

// Between two rings with different numbers of vertices, and at the ends of the budget.
TEST(Ocean, NeighbouringRingsLeaveNoHole) {
    for (const char* budget : {"0.25", "1", "4", "16"})
        for (const double distance : {6.0, 25.0, 90.0}) {
            Shot shot = shot_of("15", {{"view", "one"}, {"budget", budget}, {"wind", "12"}}, "height", {160, 160});
            shot.camera = {.yaw = 25, .pitch = 55, .distance = distance, .target = {0, 4, 0}};
            const Image found = drawn("15", shot);
            for (size_t i = 0; i < found.values.size(); i += 4)
                ASSERT_NE(found.values[i], no_surface)
                    << "budget " << budget << ", " << distance << " m, pixel " << i / 4;
        }
}

TEST(Ocean, DisplacedWavesKeepTheBudgetAndLeaveNoHole) {
    Shot shot = shot_of("15", {{"view", "one"}, {"budget", "0.5"}}, "height", {96, 96});
    shot.camera = {.yaw = 200, .pitch = 40, .distance = 20, .target = {0, 0, 0}};
    const Image found = drawn("15", shot);
    EXPECT_TRUE(std::all_of(found.values.begin(), found.values.end(), [](float v) { return std::isfinite(v); }));
    // 96 pixels over 2 x 20 m x tan(20 degrees): half a pixel is 0.08 m, twice the root mean square.
    EXPECT_LT(error_of("15", shot).mean, 0.04);
    EXPECT_LT(error_of("15", shot).p99, 0.16);
}

TEST(Ocean, WavesBelowTheBudgetGetNoFinerGrid) {
    const auto triangles_of = [](std::vector<Knob> knobs) {
        return work_of("15", shot_of("15", std::move(knobs), "", {64, 64})).triangles;
    };
    const int64_t flat = triangles_of({{"view", "one"}, {"displace", "false"}});
    EXPECT_LT(flat, 26 * 48 * 2 / 3) << "patches outside of the picture are culled";
    EXPECT_GT(triangles_of({{"view", "one"}, {"budget", "0.25"}}), 3 * flat);
    EXPECT_LT(triangles_of({{"view", "one"}, {"wind", "0"}, {"amplitude_1", "0.001"}, {"amplitude_2", "0.001"}}),
              flat + 10);
}

TEST(Ocean, UnusedMapsAreNotLoaded) {
    const auto bytes = [](std::vector<Knob> knobs) {
        return work_of("15", shot_of("15", std::move(knobs), "", {32, 32})).texture_bytes;
    };
    const int64_t all = bytes({{"view", "one"}});
    EXPECT_EQ(all, 2 * bytes({{"view", "one"}, {"amplitude_2", "0"}})) << "the second map";
    EXPECT_LT(bytes({{"view", "one"}, {"far", "plain"}}), 0.6 * double(all)) << "moments";
    EXPECT_LT(bytes({{"view", "one"}, {"far", "plain"}, {"displace", "false"}}), 0.12 * double(all)) << "heights";
}

TEST(Ocean, TheSunOfACubeMapStandsStill) {
    const auto corner = [](const char* sky, const char* yaw) {
        const Image picture =
            drawn("15", shot_of("15", {{"view", "one"}, {"sky", sky}, {"light_yaw", yaw}}, "", {96, 64}));
        return std::vector<float>(picture.pixel(0, 0), picture.pixel(0, 0) + 3);
    };
    EXPECT_EQ(corner("cube", "0"), corner("cube", "40"));
    EXPECT_NE(corner("formula", "0"), corner("formula", "40"));
}

TEST(Ocean, HeightsOfAFileGiveTheWavesOfTheFormulaTheyCameFrom) {
    const auto maps = make_maps(0);
    Image grey(map_texels, map_texels, 1, 16);
    for (size_t i = 0; i < grey.values.size(); ++i) grey.values[i] = 0.5f + 0.4f * maps.waves.values[3 * i + 2];
    const TemporaryFolder folder;
    const std::string file = (folder.path() / "waves.png").string();
    write_image(file, grey);
    const auto normals = [](const std::vector<Knob>& more) {
        return drawn("15", from_above(near_sea(more), "normal"));
    };
    const Image formula = normals({});
    // Central differences flatten the shortest waves, 17 texels long, by 2 %; slopes are 0.2 and less.
    EXPECT_LT(summarize(error_image(normals({{"heights_1", file}}), formula, ErrorMetric::angle)).mean, 0.4);
    EXPECT_GT(summarize(error_image(normals({{"heights_2", file}}), formula, ErrorMetric::angle)).mean, 2)
        << "the other map";
}

/// Writes heights of map_texels a side, in 16 bits: `height` of u and v, from 0 to 1. Returns the file's name.
template <class Height>
std::string write_heights(const TemporaryFolder& folder, Height height) {
    Image grey(map_texels, map_texels, 1, 16);
    for (int y = 0; y < map_texels; ++y)
        for (int x = 0; x < map_texels; ++x)
            *grey.pixel(x, y) = float(height((x + 0.5) / map_texels, 1 - (y + 0.5) / map_texels));
    const std::string file = (folder.path() / "heights.png").string();
    write_image(file, grey);
    return file;
}

double sine(double u, double v) { return 0.5 + 0.4 * std::sin(2 * glm::pi<double>() * (2 * u + 3 * v)); }

TEST(Ocean, HeightsOfAFileHaveTheirOwnSlopesAsExactOnes) {
    const TemporaryFolder folder;
    for (const std::string number : {"1", "2"}) {
        const Knob own = {"heights_" + number, write_heights(folder, sine)};
        const auto normals = [&](const char* source) {
            return drawn("15", from_above(near_sea({own, {"normals", source}}), "normal"));
        };
        // Normals of 8 bits are 0.2 degrees off; the slopes of the built-in waves would be 5 and more.
        EXPECT_LT(summarize(error_image(normals("maps"), normals("analytic"), ErrorMetric::angle)).mean, 0.3) << number;

        // Below the sea are the errors of both rules, from black to yellow at 12 degrees, each with its mean in a
        // label, and a scale.
        const Image halves = drawn("15", shot_of("15", {own}, "", {256, 160}));
        const auto redness = [&](int left) {
            double sum = 0;
            for (int y = 138; y < 150; ++y)
                for (int x = left; x < left + 128; ++x) sum += double(halves.pixel(x, y)[0]) / (12 * 128);
            return sum;
        };
        EXPECT_GT(redness(0), 0.2) << "the mean of normals, map " << number;
        EXPECT_LT(redness(128), 0.02) << "the sum of slopes, map " << number;
    }
}

// The slope of a single ridge is 8 times the root mean square of its map, since most texels are level. It is 0.91 here,
// and 0.84 mirrors the sun.
TEST(Ocean, SamplesOfAFileLoseNoSteepTexel) {
    const TemporaryFolder folder;
    const Knob own = {"heights_1", write_heights(folder, [](double u, double) {
                          return std::min(u, 1 - u) < 1.0 / map_texels ? 1.0 : 0.0;
                      })};
    const auto light = [&](const char* rule) {
        Shot shot = from_above(near_sea({own,
                                         {"waves", "first"},
                                         {"tiles_1", "1"},
                                         {"wind", "0"},
                                         {"amplitude_1", "0.04"},
                                         {"light_pitch", "10"},
                                         {"light_yaw", "90"},
                                         {"shininess", "1024"},
                                         {"far", rule}}),
                               "glitter");
        shot.camera.pitch = 89, shot.camera.distance = 3;  // a pixel is smaller than a texel
        return sum_of(drawn("15", shot));
    };
    const double lean = light("lean");
    EXPECT_GT(lean, 0.5) << "the ridge mirrors the sun";
    EXPECT_GT(light("samples"), lean) << "a Gaussian of the slopes between two texels spreads the light";
}

TEST(Ocean, NormalsOfAFileAreReadInPlaceOfThoseOfTheHeights) {
    Image flat(4, 4, 3, 8);
    for (size_t i = 0; i < flat.values.size(); ++i) flat.values[i] = i % 3 == 2 ? 1.0f : 0.5f;
    const TemporaryFolder folder;
    const std::string file = (folder.path() / "flat.png").string();
    write_image(file, flat);
    const Image normals = drawn("15", from_above(near_sea({{"normals_1", file}, {"waves", "first"}}), "normal"));
    for (size_t i = 0; i < normals.pixel_count(); ++i)
        if (normals.values[4 * i] != no_surface) {
            ASSERT_GT(normals.values[4 * i + 1], 0.999f) << "8 bits have no 0";
        }
}

}  // namespace
}  // namespace relief
