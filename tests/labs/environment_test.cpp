// Lab 16: the occlusion of each light, and its error against the exact value.
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "framework/library/kit/evening_sky.h"
#include "framework/staff/reference/ambient_occlusion.h"
#include "labs/16_environment/scene.h"
#include "tests/labs/shots.h"

namespace relief {
namespace {

/// Returns a shot of the court with a flat floor and with its maps at mip level 0. `more` overrides these knobs.
Shot court_shot(const char* probe, const std::vector<Knob>& more = {}, glm::ivec2 size = {96, 96}) {
    return shot_of("16", with({{"level", "0"}, {"displace", "false"}}, more), probe, size);
}

// ---- the sun's shadow

Shot plane_shot(const char* scene, double tilt, double yaw, double pitch, const char* pcf, const char* texels) {
    Shot shot = shot_of("16",
                        {{"scene", scene},
                         {"tilt", std::to_string(tilt)},
                         {"light_yaw", std::to_string(yaw)},
                         {"light_pitch", std::to_string(pitch)},
                         {"pcf", pcf},
                         {"shadow_texels", texels}},
                        "shadow", {96, 96});
    shot.camera = {.yaw = tilt > 0 ? -50.0 : 50.0, .pitch = 50, .distance = 10, .target = {0, 0, 0}};
    return shot;
}

/// Counts the pixels of a plane that faces the sun, and its falsely shadowed pixels.
struct Shadows {
    int pixels = 0, false_ones = 0;
};
Shadows shadows_of(const Shot& shot) {
    const auto lab = make_lab(find_lab("16"), shot);
    const Image drawn = render_shot(*lab, shot), exact = truth_of(*lab, shot);
    Shadows found;
    for (size_t i = 0; i < drawn.values.size(); i += 4)
        if (exact.values[i] == 1 && std::isfinite(drawn.values[i]))
            ++found.pixels, found.false_ones += drawn.values[i] < 1;
    return found;
}

TEST(Environment, NoPlaneHasAFalseShadowFromAnyLight) {
    int pixels = 0, without = 0;
    for (const double tilt : {0.0, 17.0, -40.0, 63.0, -80.0})
        for (const double yaw : {-170.0, -75.0, 0.0, 33.0, 121.0})
            for (const double pitch : {90.0, 61.0, 24.0, 3.0}) {
                const char* pcf = int(yaw) % 2 ? "1" : pitch > 50 ? "2" : "0";
                Shot shot = plane_shot("plane", tilt, yaw, pitch, pcf, "512");
                const Shadows found = shadows_of(shot);
                EXPECT_EQ(found.false_ones, 0) << "tilt " << tilt << ", light " << yaw << ", " << pitch;
                pixels += found.pixels;
                shot.set.emplace_back("bias", "none");
                without += shadows_of(shot).false_ones;
            }
    EXPECT_GT(pixels, 100000) << "what was looked at";
    EXPECT_GT(without, pixels / 5) << "without a bias planes hide themselves";
}

TEST(Environment, AShadowsEdgeIsWithinRadiusAndATexel) {
    for (const int radius : {0, 1, 2}) {
        Shot shot = plane_shot("board", 0, 30, 60, std::to_string(radius).c_str(), "256");
        shot.camera = {.yaw = 0, .pitch = 89, .distance = 3, .target = {-0.35, 0, -0.6}};
        const auto lab = make_lab(find_lab("16"), shot);
        const Image drawn = render_shot(*lab, shot), exact = truth_of(*lab, shot);
        // The size of a texel in metres (at most the diagonal of the scene's box), converted to pixels of the ground.
        // Light at a slant stretches it.
        const double texel = 10.6 / 256, pixel = 2 * 3 * std::tan(glm::radians(20.0)) / 96;
        const int wide = int(std::ceil((radius + 1) * texel / pixel / std::sin(glm::radians(60.0)))) + 1;
        int seen = 0;
        for (int y = wide; y < 96 - wide; ++y)
            for (int x = wide; x < 96 - wide; ++x) {
                double low = 1, high = 0;
                for (int j = -wide; j <= wide; ++j)
                    for (int i = -wide; i <= wide; ++i) {
                        low = std::min(low, double(*exact.pixel(x + i, y + j)));
                        high = std::max(high, double(*exact.pixel(x + i, y + j)));
                    }
                if (low != high) continue;
                ++seen;
                EXPECT_EQ(*drawn.pixel(x, y), low) << x << ", " << y << ", radius " << radius;
            }
        EXPECT_GT(seen, 500);
        double hidden = 0;
        for (size_t i = 0; i < exact.values.size(); i += 4) hidden += exact.values[i] == 0;
        EXPECT_GT(hidden, 300) << "the board's shadow";
    }
}

TEST(Environment, ADisplacedFloorCastsAndReceivesShadows) {
    Shot shot =
        shot_of("16", {{"light_yaw", "0"}, {"light_pitch", "2"}, {"shadow_texels", "2048"}}, "shadow", {128, 128});
    shot.camera = {.yaw = 0, .pitch = 85, .distance = 9, .target = {0, 0, 4}, .field_of_view = 40};
    const auto lab = make_lab(find_lab("16"), shot);
    const Image drawn = render_shot(*lab, shot);
    // The reference marches the height formula in steps of a centimetre, from the hit of the eye's ray.
    const Frame frame = {0, shot.size, 0, Camera(shot.camera, 1), {}};
    const glm::dvec3 to_sun(0, std::sin(glm::radians(2.0)), std::cos(glm::radians(2.0)));
    int hidden = 0, wrong = 0, count = 0;
    for (int y = 0; y < 128; y += 2)
        for (int x = 0; x < 128; x += 2) {
            const Ray ray = frame.ray(x, y);
            double t = (0.2 - ray.origin.y) / ray.direction.y;
            const auto above = [&](const glm::dvec3& p) { return p.y - court::floor_at({p.x, p.z}).height; };
            while (above(ray.at(t)) > 0) t += 0.002;
            const glm::dvec3 from = ray.at(t);
            if (std::abs(from.x) > 6.2 || from.z < 1.6 || from.z > 6.5) continue;  // no other object casts shadows here
            bool is_lit = true;
            for (double s = 0.05; s < 5 && from.z + s < 7; s += 0.01)
                is_lit = is_lit && above(from + s * to_sun) > -1e-3;
            ++count, hidden += !is_lit;
            wrong += std::abs(double(*drawn.pixel(x, y)) - is_lit) > 0.5;
        }
    EXPECT_GT(hidden, count / 20) << "humps hide what lies behind them";
    // Triangles with sides of a third of a metre are chords of the humps.
    EXPECT_LT(wrong, count / 12) << "of " << count << ", " << hidden << " hidden";
    shot.set.emplace_back("displace", "false");
    const Image flat = relief::drawn("16", shot);
    for (size_t i = 0; i < flat.values.size(); i += 4)
        if (std::isfinite(flat.values[i])) hidden -= flat.values[i] < 1;
    EXPECT_GT(hidden, count / 20) << "a flat floor casts none";
}

// ---- the exact values of a displaced floor

/// The side of a cell of the displaced floor, metres: the court of 14 metres has 24 along each side.
constexpr double cell = 14.0 / 24;

/// Returns the exact values of a probe on the displaced floor, or on the flat one.
Image exact_floor(Shot shot, const char* probe, const char* displaced) {
    shot.probe.name = probe;
    shot.set.emplace_back("displace", displaced);
    return truth_of(*make_lab(find_lab("16"), shot), shot);
}

TEST(Environment, APuddleHasTheExactValuesOfAFlatFloor) {
    Shot shot = court_shot("", {}, {64, 64});
    shot.camera = {.yaw = 0, .pitch = 89, .distance = 9, .target = {0, 0, 3}};
    const Frame frame = {0, shot.size, 0, Camera(shot.camera, 1), {}};
    for (const char* probe : {"normal", "reflection", "fresnel", "exponent"}) {
        const Image displaced = exact_floor(shot, probe, "true"), flat = exact_floor(shot, probe, "false");
        int puddles = 0, humps = 0;
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x) {
                const Ray ray = frame.ray(x, y);
                const glm::dvec3 hit = ray.at(-ray.origin.y / ray.direction.y);
                if (std::abs(hit.x) > 5 || hit.z < 1 || hit.z > 5) continue;  // no bench, no wall
                // A triangle with all corners in a puddle is flat.
                const glm::dvec2 corner = glm::floor((glm::dvec2(hit.x, hit.z) + 7.0) / cell) * cell - 7.0;
                double highest = 0;
                for (int i = 0; i < 4; ++i)
                    highest = std::max(highest, court::floor_at(corner + cell * glm::dvec2(i % 2, i / 2)).height);
                if (highest > 0 || court::floor_at({hit.x, hit.z}).height > 0) {
                    humps += displaced.pixel(x, y)[0] != flat.pixel(x, y)[0];
                    continue;
                }
                ++puddles;
                // The roundings of a hit differ, by 1e-15 metres; a texel of the maps is 1/256 metres wide.
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(displaced.pixel(x, y)[c], flat.pixel(x, y)[c], 1e-4) << probe << " " << x << ", " << y;
            }
        EXPECT_GT(puddles, 100);
        EXPECT_GT(humps, 100);
    }
}

TEST(Environment, AtAVertexOfTheFloorTheExactMirrorImageIsThatOfTheHeightsSlope) {
    int slanted = 0;
    for (const glm::ivec2 vertex : {glm::ivec2(6, 21), {6, 15}, {5, 21}, {8, 15}, {9, 16}, {14, 15}}) {
        const glm::dvec2 place = cell * glm::dvec2(vertex) - 7.0;
        const auto height = [](const glm::dvec2& at) { return court::floor_at(at).height; };
        const double step = 1e-5, rise_x = height(place + glm::dvec2(step, 0)) - height(place - glm::dvec2(step, 0)),
                     rise_z = height(place + glm::dvec2(0, step)) - height(place - glm::dvec2(0, step));
        const glm::dvec3 face = glm::normalize(glm::dvec3(-rise_x, 2 * step, -rise_z));
        slanted += face.y < 0.999;
        // A sky without blur, mirrored by the surface without its bumps. With light_yaw 0 the sky is not turned.
        Shot shot = court_shot("", {{"gloss", "mirror"}, {"normal_for", "lamps"}, {"light_yaw", "0"}}, {1, 1});
        shot.camera = {.yaw = 160, .pitch = 50, .distance = 1, .target = {place.x, height(place), place.y}};
        const glm::dvec3 along = Camera(shot.camera, 1).ray({0, 0}).direction;
        const glm::dvec3 expected = evening_sky(glm::reflect(along, face));
        const Image exact = exact_floor(shot, "reflection", "true");
        // Positions are floats: 1e-6 metres change the slope of a hump by less than 1e-5.
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(exact.values[size_t(c)], expected[c], 1e-4) << vertex.x << ", " << vertex.y;
    }
    EXPECT_GE(slanted, 3);
}

TEST(Environment, ADisplacedFloorIsDrawnWithTheErrorOfAFlatOne) {
    // Single precision in uv of a few tiles is 1e-6 of a tile, 1e-3 of a texel. Between two texels a normal may differ
    // by a radian, a share and a gloss by 1; the exponent of a gloss of 1 is 256.
    for (const auto& [probe, most] : {std::pair{"normal", 0.06}, {"fresnel", 0.001}, {"exponent", 0.256}})
        for (const char* displaced : {"true", "false"}) {
            Shot shot = court_shot(probe, {{"displace", displaced}});
            shot.camera = {.yaw = 0, .pitch = 60, .distance = 7, .target = {0, 0, 3}};
            EXPECT_LT(error_of("16", shot).p99, most) << probe << ", displaced " << displaced;
        }
}

// ---- occlusion

TEST(Environment, TheIntegralGivesTheCosineOfASlopeBetweenTwoEndlessWalls) {
    for (const double slope : {10.0, 30.0, 45.0, 60.0}) {
        // At the bottom, with a vertical normal. A slice that is not perpendicular to the walls sees a smaller slope.
        constexpr int slices = 64;
        double sum = 0, older = 0;
        for (int i = 0; i < slices; ++i) {
            const double angle = glm::pi<double>() * (i + 0.5) / slices;
            const double horizon = std::atan2(1, std::tan(glm::radians(slope)) * std::abs(std::cos(angle)));
            sum += open_share(-horizon, horizon, 0) / slices;
            older += (1 - std::cos(horizon)) / slices;  // 1 minus the sine of the elevation
        }
        EXPECT_NEAR(sum, std::cos(glm::radians(slope)), 1e-3) << slope;
        if (slope == 30) {
            EXPECT_NEAR(older, 0.67, 0.005);
        }
        if (slope == 45) {
            EXPECT_NEAR(older, 0.50, 0.005);
        }
    }
}

TEST(Environment, OcclusionBetweenTwoWallsHasTheErrorsOfHandout16) {
    for (const auto& [slope, handout_says] : {std::pair{15.0, 0.002}, {30.0, 0.006}, {45.0, 0.014}}) {
        Shot shot =
            shot_of("16", {{"scene", "groove"}, {"tilt", std::to_string(slope)}, {"slices", "16"}, {"taps", "48"}},
                    "occlusion", {48, 320});
        shot.camera = {.yaw = 0, .pitch = 89, .distance = 22, .target = {0, 0, 0}, .field_of_view = 40};
        const auto lab = make_lab(find_lab("16"), shot);
        const Image drawn = render_shot(*lab, shot), exact = truth_of(*lab, shot);
        double off = 0;
        int count = 0;
        for (int x = 0; x < 48; ++x) {
            if (!std::isfinite(*drawn.pixel(x, 160))) continue;
            off += std::abs(double(*drawn.pixel(x, 160)) - double(*exact.pixel(x, 160)));
            ++count;
        }
        EXPECT_GT(count, 20);
        EXPECT_NEAR(off / count, handout_says, 0.00051) << slope;
    }
}

/// The groove from above, with enough slices and taps that the error is that of the guess.
Shot mirror_shot(const char* tilt, const char* exponent, const char* guess) {
    Shot shot = shot_of("16",
                        {{"scene", "groove"},
                         {"tilt", tilt},
                         {"gloss", "even"},
                         {"exponent", exponent},
                         {"mirror_occlusion", guess},
                         {"slices", "8"},
                         {"taps", "16"}},
                        "mirror_open", {48, 48});
    shot.camera = {.yaw = 0, .pitch = 60, .distance = 3, .target = {0, 0, 0}, .field_of_view = 40};
    return shot;
}

TEST(Environment, TheOpenShareOfAMirroredLobeIsItsIntegralOverTheGroovesHorizons) {
    for (const double tilt : {30.0, 45.0})
        for (const double exponent : {8.0, 64.0, 512.0}) {
            const Shot shot = mirror_shot(std::to_string(tilt).c_str(), std::to_string(exponent).c_str(), "none");
            const Image exact = truth_of(*make_lab(find_lab("16"), shot), shot);
            const Frame frame{0, shot.size, 0, Camera(shot.camera, 1), {}};
            const double steep = std::tan(glm::radians(tilt));
            int seen = 0;
            for (const int x : {8, 17, 22, 26, 31, 40}) {
                const float value = *exact.pixel(x, 24);
                if (!std::isfinite(value)) continue;
                ++seen;
                // The walls are y = steep |x|, up to |x| = 1.
                const Ray ray = frame.ray(x, 24);
                const double side = x < 24 ? -1 : 1;
                const double t =
                    (side * steep * ray.origin.x - ray.origin.y) / (ray.direction.y - side * steep * ray.direction.x);
                const glm::dvec3 place = ray.at(t), face = glm::normalize(glm::dvec3(-side * steep, 1, 0)),
                                 middle = glm::normalize(glm::reflect(ray.direction, face)),
                                 right = glm::normalize(glm::cross(middle, glm::dvec3(0.3, 0.5, 0.8))),
                                 up = glm::cross(middle, right);
                double open = 0;
                constexpr int rings = 120, spokes = 240;
                for (int i = 0; i < rings; ++i)
                    for (int j = 0; j < spokes; ++j) {
                        const double c = std::pow((i + 0.5) / rings, 1 / (exponent + 1)), s = std::sqrt(1 - c * c),
                                     turn = 2 * glm::pi<double>() * j / spokes;
                        const glm::dvec3 way = c * middle + s * (std::cos(turn) * right + std::sin(turn) * up);
                        const double to_edge = side * place.x + 1, rise = steep - place.y;
                        const bool is_under = side * way.x < 0 && way.y * to_edge < rise * -side * way.x;
                        open += glm::dot(way, face) > 0 && !is_under;
                    }
                EXPECT_NEAR(double(value), open / (rings * spokes), 0.05) << tilt << ' ' << exponent << ' ' << x;
            }
            EXPECT_GE(seen, 4);
        }
}

TEST(Environment, AGuessByRoughnessBeatsTheSkysOcclusionOnASharpMirror) {
    // On a rough one they are alike: the lobe is as wide as the sky.
    for (const auto& [exponent, most] : {std::pair{"64", 0.03}, {"512", 0.012}}) {
        const double none = error_of("16", mirror_shot("30", exponent, "none")).mean,
                     as_sky = error_of("16", mirror_shot("30", exponent, "as-sky")).mean,
                     lagarde = error_of("16", mirror_shot("30", exponent, "lagarde")).mean;
        EXPECT_LT(lagarde, none) << exponent;
        EXPECT_LT(lagarde, most) << exponent << ": handout 16 has 0.027 and 0.011";
        EXPECT_LT(none, as_sky) << exponent << ": a mirror reflects one direction";
    }
    EXPECT_LT(error_of("16", mirror_shot("30", "8", "as-sky")).mean,
              error_of("16", mirror_shot("30", "8", "none")).mean / 2);
}

TEST(Environment, APlaneIsUnoccluded) {
    Shot shot = shot_of("16", {{"scene", "plane"}, {"tilt", "0"}}, "occlusion", {128, 128});
    shot.camera = {.yaw = 30, .pitch = 40, .distance = 1.2, .target = {2.2, 0, 2.2}};
    const Image image = drawn("16", shot);
    // Two slices, each at four angles. The angles are evenly spaced in the picture only.
    for (size_t i = 0; i < image.values.size(); i += 4) ASSERT_NEAR(image.values[i], 1, 0.05);
}

// ---- the sum

TEST(Environment, TheTableExplainsAPixelOfTheSamePicture) {
    // Except for the cross and the table, the picture equals the court.
    Shot shot = court_shot("", {{"view", "one-pixel"}, {"pixel_x", "0.25"}, {"pixel_y", "0.25"}}, {64, 64});
    const Image table = drawn("16", shot);
    shot.set[2].second = "court";
    const Image plain = drawn("16", shot);
    size_t same = 0;
    for (size_t i = 0; i < plain.values.size(); i += 4) same += plain.values[i] == table.values[i];
    EXPECT_GT(same, plain.pixel_count() / 10);
    EXPECT_LT(same, plain.pixel_count() - 20);
}

// ---- skipped work

TEST(Environment, DisabledTermsLoadNoMapAndDrawNothing) {
    const auto work = [](std::vector<Knob> knobs) {
        return work_of("16", shot_of("16", std::move(knobs), "light", {32, 32}));
    };
    const Work all = work({}), no_shadow = work({{"shadow", "false"}}), no_ao = work({{"ao", "false"}}),
               no_sky = work({{"reflection", "false"}});
    EXPECT_EQ(all.texture_bytes - no_shadow.texture_bytes, 1024 * 1024 * 4) << "the depth map";
    EXPECT_EQ(all.draws - no_shadow.draws, 4) << "floor, bricks, stone, marble";
    EXPECT_EQ(all.texture_bytes - no_ao.texture_bytes, 3 * 32 * 32 * 16) << "surfaces, openness, and that smoothed";
    EXPECT_EQ(all.draws - no_ao.draws, 4 + 2);
    EXPECT_GT(all.texture_bytes - no_sky.texture_bytes, 6 * 128 * 128 * 12) << "the sky";
}

TEST(Environment, TheShadowMapIsRedrawnOnlyAfterTheSunOrTheSceneMoves) {
    Shot shot = shot_of("16", {{"ao", "false"}}, "", {32, 32});
    const auto lab = make_lab(find_lab("16"), shot);
    const auto calls = [&] { return work_of(*lab, shot).draws; };
    const int64_t first = calls();
    EXPECT_EQ(first - calls(), 4);
    shot.camera.yaw += 30;
    EXPECT_EQ(first - calls(), 4) << "the eye moved";
    set_knob(*lab, "light_pitch", "20");
    EXPECT_EQ(calls(), first) << "the sun moved";
    set_knob(*lab, "displace", "false");
    EXPECT_EQ(calls(), first) << "the floor moved";
    EXPECT_EQ(first - calls(), 4);
}

}  // namespace
}  // namespace relief
