// Lab 09: normals on a curved and skewed grid, patches that meet, and patches that are culled.
#include "framework/core/gl/counters.h"
#include "framework/core/gl/program.h"
#include "labs/09_planet/globe.h"
#include "labs/09_planet/staff/exact.h"
#include "labs/09_planet/task.h"
#include "tests/labs/shots.h"
#include "tests/support.h"

namespace relief {
namespace {

using namespace planet;

TEST(Planet, TheExactGradientMatchesDifferencesAndASmoothBallsNormalIsRadial) {
    Dice dice(9);
    for (int detail = 0; detail <= 5; ++detail)
        for (int i = 0; i < 200; ++i) {
            const Ground ground{.seed = i, .detail = detail};
            const glm::dvec3 r = dice.direction();
            const glm::dvec3 gradient = exact_height(ground, r).gradient;
            EXPECT_NEAR(glm::dot(gradient, r), 0, 1e-12);
            for (const glm::dvec3 axis : {glm::dvec3(1, 0, 0), {0, 1, 0}, {0, 0, 1}}) {
                const double e = 1e-6;
                const double slope =
                    (height(ground, glm::normalize(r + e * axis)) - height(ground, glm::normalize(r - e * axis))) /
                    (2 * e);
                // Second derivatives of the noise jump by at most 60. The error is at most half of that times e.
                ASSERT_NEAR(glm::dot(gradient, axis), slope, 1e-4) << "seed " << i << ", detail " << detail;
            }
            EXPECT_LT(glm::distance(exact_normal({.seed = i, .height = 0}, r), r), 1e-14);
        }
}

TEST(Planet, ExactHitsLieOnTheGroundAndEqualASpheresOnASmoothBall) {
    Dice dice(9);
    int hits = 0;
    for (int i = 0; i < 300; ++i) {
        const Ray ray{3.0 * dice.direction(), {}};
        const Ray aimed{ray.origin, glm::normalize(0.9 * dice.direction() - ray.origin)};
        const double b = glm::dot(aimed.origin, aimed.direction), root = b * b - 8;
        const Shape smooth{.ground = {.seed = 1, .height = 0}}, rough{.ground = {.seed = 1}};
        const auto hit = exact_hit(smooth, aimed);
        ASSERT_EQ(hit.has_value(), root > 0);
        if (hit) {
            EXPECT_NEAR(*hit, -b - std::sqrt(root), 1e-9);
        }
        const auto met = exact_hit(rough, aimed);
        hits += met.has_value();
        if (!met) continue;
        const double radius = glm::length(aimed.at(*met));
        EXPECT_NEAR(radius, 1 + height(rough.ground, aimed.at(*met) / radius), 1e-12);
        for (double t = *met - 0.3; t < *met - 1e-6; t += 0.004) {  // no hit before it
            const double there = glm::length(aimed.at(t));
            EXPECT_GT(there, 1 + height(rough.ground, aimed.at(t) / there));
        }
    }
    EXPECT_GT(hits, 200);
}

TEST(Planet, TheExactDirectionIsTheGridsOwn) {
    Dice dice(9);
    for (const SphereMapping mapping : {SphereMapping::equal_angle, SphereMapping::gnomonic, SphereMapping::lat_long})
        for (int i = 0; i < 300; ++i) {
            const glm::dvec3 r = dice.direction();
            const auto [face, st] = face_place(mapping, r);
            EXPECT_LT(glm::distance(exact_direction(mapping, face, st), r), 1e-14);
        }
}

double degrees(std::vector<Knob> knobs, int texels, int level = 0) {
    knobs.insert(knobs.end(), {{"view", "faces"}, {"seed", "1"}, {"detail", "1"}, {"level", std::to_string(level)}});
    knobs.emplace_back("texels", std::to_string(texels >> level));
    return error_of("09", shot_of("09", knobs, "normal", {3 * texels, 2 * texels})).mean;
}

TEST(Planet, NormalErrorsFallWithTheTexelsAtEveryLevel) {
    EXPECT_LT(degrees({}, 64), 1.41);
    EXPECT_LT(degrees({}, 128), 0.37);
    EXPECT_LT(degrees({}, 256), 0.094);
    // Four or sixteen patches per face, with the same number of texels in total.
    EXPECT_NEAR(degrees({}, 128, 1), degrees({}, 128), 1e-4);
    EXPECT_NEAR(degrees({}, 128, 2), degrees({}, 128), 1e-4);
    EXPECT_LT(degrees({{"slopes_from", "formula"}}, 64), 0.02);
    // Errors that do not decrease with the number of texels.
    EXPECT_GT(degrees({{"normals", "b-by-cross"}}, 256), 0.5);
    EXPECT_GT(degrees({{"normals", "right-angled"}}, 256), 0.7);
    EXPECT_GT(degrees({{"strength", "1+2^level"}}, 128, 1), 1.5);
    EXPECT_GT(degrees({{"strength", "1+2^level"}}, 128, 2), 2.2);
    EXPECT_LT(degrees({{"strength", "1+2^level"}}, 64), 1.41) << "at level 0 it is right";
    EXPECT_GT(degrees({{"strength", "none"}}, 128, 1), 3);
    EXPECT_LT(degrees({{"mapping", "gnomonic"}}, 256), 0.12);
}

TEST(Planet, AGutterLeavesNoJumpAtBorders) {
    const auto border = [](const char* gutter) {
        Shot shot =
            shot_of("09", {{"view", "faces"}, {"seed", "1"}, {"detail", "1"}, {"texels", "128"}, {"gutter", gutter}},
                    "normal", {384, 256});
        const auto lab = make_lab(find_lab("09"), shot);
        const Image errors = error_image(render_shot(*lab, shot), truth_of(*lab, shot), ErrorMetric::angle);
        double at_border = 0, within = 0;
        int borders = 0, others = 0;
        for (int y = 0; y < 256; ++y)
            for (int x = 0; x < 384; ++x) {
                const int s = x % 128, t = y % 128;
                const bool is_border = s == 0 || t == 0 || s == 127 || t == 127;
                (is_border ? at_border : within) += double(*errors.pixel(x, y));
                ++(is_border ? borders : others);
            }
        return std::pair(at_border / borders, within / others);
    };
    const auto [with, within] = border("true");
    EXPECT_LT(with, 1.15 * within);
    const auto [without, still_within] = border("false");
    EXPECT_GT(without, 5 * still_within);
}

TEST(Planet, ATexelInTheMiddleIs130TimesACornersWithEqualAngles) {
    // Share of a texel's area: sec^2 a sec^2 b / (1 + tan^2 a + tan^2 b)^(3/2); at 45 degrees 1.41 on an edge, 1.30 in
    // a corner.
    const Image image = drawn("09", shot_of("09", {{"mapping", "equal-angle"}}, "stretch", {384, 256}));
    const double middle = double(*image.pixel(64, 64));
    EXPECT_NEAR(middle / double(*image.pixel(0, 0)), 1.30, 0.02);
    EXPECT_NEAR(middle / double(*image.pixel(64, 0)), 1.41, 0.02);
}

TEST(Planet, TexelsDifferByAThirdAndLinesCrossAt120DegreesInTheCorners) {
    const auto ends = [](const char* mapping, const char* probe) {
        const Image image = drawn("09", shot_of("09", {{"mapping", mapping}}, probe, {384, 256}));
        double low = INFINITY, high = 0;
        for (size_t i = 0; i < image.values.size(); i += 4) {
            low = std::min(low, double(image.values[i])), high = std::max(high, double(image.values[i]));
        }
        return std::pair(low, high);
    };
    // The limits are sqrt(2) and 3 sqrt(3). Half a pixel from the corners the values are slightly smaller.
    const auto [small, large] = ends("equal-angle", "stretch");
    EXPECT_NEAR(large / small, std::sqrt(2), 0.02);
    const auto [narrow, wide] = ends("gnomonic", "stretch");
    EXPECT_NEAR(wide / narrow, 3 * std::sqrt(3), 0.12);
    const auto [sharp, blunt] = ends("equal-angle", "corner");
    EXPECT_NEAR(sharp, 60, 1);
    EXPECT_NEAR(blunt, 120, 1);
}

Plan near_ground(Dice& dice, double altitude) {
    Plan plan;
    plan.shape.ground.seed = 3, plan.budget = dice.between(0.5, 4), plan.pixels = 256;
    const glm::dvec3 up = dice.direction();
    const glm::dvec3 side = glm::normalize(glm::cross(up, dice.direction()));
    const double tilt = dice.between(-1.2, 0.3);
    plan.eye =
        Eye::looking((1 + height(plan.shape.ground, up) + altitude) * up, std::cos(tilt) * side + std::sin(tilt) * up,
                     std::cos(tilt) * up - std::sin(tilt) * side, 1, 1);
    return plan;
}

TEST(Planet, DrawsWithinItsBoundsAtTheEndsOfItsKnobs) {
    const std::vector<std::vector<Knob>> ends = {
        {{"levels", "uniform"}, {"level", "5"}, {"cull", "none"}},
        {{"levels", "uniform"}, {"level", "5"}, {"cull", "none"}, {"quads", "32"}, {"texels", "256"}},
        {{"budget", "0.25"}, {"cull", "none"}, {"quads", "8"}, {"texels", "256"}}};
    const std::vector<std::string> views = {"planet", "pole", "patches", "compare", "faces", "mountains", "frames"};
    for (const std::string& view : sample_of(views, 3))  // "compare" is one of them
        for (std::vector<Knob> set : ends) {
            if (view != "compare" && set != ends[0]) continue;  // the other settings change only the maps
            set.emplace_back("view", view);
            const Shot shot = shot_of("09", set, "", {160, 120});
            const int64_t before = counters().texture_bytes;
            const auto lab = make_lab(find_lab("09"), shot);
            EXPECT_NO_THROW(draw_shot(*lab, shot)) << view;
            // A texel has 16 bytes. A map has room for up to 64 more patches, which may double their number.
            EXPECT_LE(counters().texture_bytes - before, 2 * 16 * int64_t(most_texels)) << view;
        }
}

/// Counts the pixels of the planet on which nothing was drawn. The planet counts as a ball inside its ground, reduced
/// by the error budget at the horizon.
size_t holes(const Shot& shot, Lab& lab, const Plan& plan) {
    const Image seen = draw_shot(lab, shot);
    const double away = std::sqrt(glm::dot(plan.eye.place, plan.eye.place) - 1);
    const double radius = 1 - 2 * plan.budget * away * 2 * std::tan(plan.eye.field_of_view_rad / 2) / seen.height;
    size_t count = 0;
    for (int y = 0; y < seen.height; ++y)
        for (int x = 0; x < seen.width; ++x) {
            if (std::isfinite(*seen.pixel(x, y))) continue;
            const Ray ray = plan.eye.ray({(x + 0.5) / seen.width * 2 - 1, 1 - (y + 0.5) / seen.height * 2});
            const double b = glm::dot(ray.origin, ray.direction);
            count += b < 0 && radius > 0 && b * b - (glm::dot(ray.origin, ray.origin) - radius * radius) > 0;
        }
    return count;
}

struct GroundView {
    double longitude, latitude, heading, tilt, altitude, budget;
    std::vector<Knob> knobs(const char* skirts) const {
        const auto text = [](double x) { return std::to_string(x); };
        return {{"view", "planet"},           {"eye", "ground"},          {"longitude", text(longitude)},
                {"latitude", text(latitude)}, {"heading", text(heading)}, {"tilt", text(tilt)},
                {"altitude", text(altitude)}, {"budget", text(budget)},   {"skirts", skirts}};
    }
};

TEST(Planet, SkirtsLeaveNoHoleFromAnyCamera) {
    Dice dice(9);
    Shot shot = shot_of("09", {}, "seen", {64, 64});
    const auto lab = make_lab(find_lab("09"), shot);
    size_t without = 0;
    for (int i = 0; i < view_count(); ++i) {
        const GroundView view{dice.between(-180, 180), dice.between(-89, 89), dice.between(-180, 180),
                              dice.between(-80, -5),   dice.between(-6, 1),   dice.between(1, 3)};
        // Uses the lab's own precision for the position.
        const double lon = glm::radians(double(float(view.longitude))),
                     lat = glm::radians(double(float(view.latitude)));
        const glm::dvec3 up(std::cos(lat) * std::sin(lon), std::sin(lat), std::cos(lat) * std::cos(lon));
        const glm::dvec3 east(std::cos(lon), 0, -std::sin(lon)), north = glm::cross(up, east);
        const double turn = glm::radians(view.heading), rise = glm::radians(view.tilt);
        const glm::dvec3 ahead = std::cos(turn) * north + std::sin(turn) * east;
        Plan plan;
        plan.budget = view.budget;
        plan.eye = Eye::looking((1 + height({.seed = 3}, up) + std::pow(10.0, view.altitude)) * up,
                                std::cos(rise) * ahead + std::sin(rise) * up,
                                std::cos(rise) * up - std::sin(rise) * ahead, glm::radians(60.0), 1);
        for (const auto& [knob, value] : view.knobs("true")) set_knob(*lab, knob, value);
        ASSERT_EQ(holes(shot, *lab, plan), 0u) << "view " << i << ", altitude " << view.altitude;
        set_knob(*lab, "skirts", "false");
        without += holes(shot, *lab, plan);
    }
    EXPECT_GT(without, 0u) << "there are gaps to hide";
}

TEST(Planet, CullsNineTenthsOfThePatchesNearTheGround) {
    Dice dice(9);
    double drawn_patches = 0, all_patches = 0;
    for (int i = 0; i < 30; ++i) {
        Plan plan = near_ground(dice, 0.01);
        plan.levels = Levels::uniform, plan.level = 4;
        for (const Leaf& leaf : cover(plan).leaves) drawn_patches += leaf.state == Leaf::drawn;
        all_patches += 6 * 256;
    }
    EXPECT_LT(drawn_patches / all_patches, 0.1);
    EXPECT_GT(drawn_patches, 0);
}

TEST(Planet, LevelsByErrorNeedLessThanHalfTheTrianglesOfUniformLevels) {
    Dice dice(9);
    double adaptive = 0, uniform = 0;
    for (int i = 0; i < 20; ++i) {
        Plan plan = near_ground(dice, 0.05);
        plan.budget = 2;
        int finest = 0;
        for (const Leaf& leaf : cover(plan).leaves)
            if (leaf.state == Leaf::drawn) ++adaptive, finest = std::max(finest, leaf.id.level);
        // For the same error on the screen, uniform levels need the finest level everywhere.
        plan.levels = Levels::uniform, plan.level = finest;
        for (const Leaf& leaf : cover(plan).leaves) uniform += leaf.state == Leaf::drawn;
    }
    EXPECT_LT(adaptive, 0.5 * uniform) << adaptive << " of " << uniform;
}

TEST(Planet, CulledPatchesAreInvisible) {
    // The patches that task 9.7 culls contribute no pixel: the picture equals that of all patches.
    for (const auto& [altitude, tilt] : {std::pair("-3", "-2"), {"-1.5", "-12"}, {"0", "-60"}}) {
        const std::vector<Knob> knobs = {{"view", "planet"}, {"eye", "ground"},     {"altitude", altitude},
                                         {"tilt", tilt},     {"levels", "uniform"}, {"level", "3"},
                                         {"seed", "8"},      {"skirts", "false"}};
        std::vector<Knob> all = knobs;
        all.emplace_back("cull", "none");
        EXPECT_EQ(drawn("09", shot_of("09", knobs, "place", {96, 96})).values,
                  drawn("09", shot_of("09", all, "place", {96, 96})).values)
            << altitude;
    }
}

TEST(Planet, IsTheSameFromAMetreToTheSizeOfTheEarth) {
    const auto picture = [](const char* radius) {
        return drawn("09", shot_of("09", {{"view", "planet"}, {"texels", "32"}, {"radius", radius}}, "", {96, 96}));
    };
    const Image earth = picture("6.804");
    for (const char* radius : {"0", "3", "7"}) expect_same_picture(picture(radius), earth, 3, 20);
}

TEST(Planet, SubtractingTheEyeInDoubleKeepsTheGroundStill) {
    const auto metres = [](const char* precise) {
        Shot shot = shot_of(
            "09", {{"view", "planet"}, {"eye", "ground"}, {"altitude", "-4.5"}, {"tilt", "-80"}, {"precise", precise}},
            "place", {64, 64});
        return error_of("09", shot).mean;
    };
    EXPECT_LT(metres("camera-relative"), 0.01) << "from 200 m above a planet as large as the Earth";
    EXPECT_GT(metres("float"), 0.05);
}

TEST(Planet, MapsAreMadeOnceAndOnlyForDrawnPatches) {
    Shot shot = shot_of("09", {{"view", "planet"}, {"texels", "32"}}, "", {96, 96});
    const auto lab = make_lab(find_lab("09"), shot);
    const auto draw_calls = [&] { return work_of(*lab, shot).draws; };
    const int64_t first = draw_calls(), still = draw_calls(), patches = still - 1;  // the sky
    EXPECT_EQ(first, still + 2 * patches) << "heights and normals of each patch";
    for (const auto& [knob, value] : {std::pair("light_yaw", "20"), {"skirts", "false"}, {"radius", "2"}}) {
        set_knob(*lab, knob, value);
        EXPECT_EQ(draw_calls(), still) << knob;
    }
    const int64_t with_culling = counters().texture_bytes;
    set_knob(*lab, "normals", "right-angled");
    EXPECT_EQ(draw_calls(), still + 2 * patches);
    for (const auto& [knob, value] : {std::pair("levels", "uniform"), {"level", "3"}}) set_knob(*lab, knob, value);
    draw_calls();
    const int64_t fine = counters().texture_bytes;
    set_knob(*lab, "cull", "none");
    draw_calls();
    EXPECT_GT(counters().texture_bytes, fine) << "maps of the far side as well";
    EXPECT_GT(fine, with_culling);
    // A probe that shows no normal creates no map.
    Shot bare = shot;
    bare.probe = {"seen"};
    EXPECT_EQ(work_of("09", bare).texture_bytes, 0);
}

TEST(Planet, HorizonSkirtsAndSplitsFollowTheirFormulas) {
    EXPECT_DOUBLE_EQ(split_distance(2, 1, 500, glm::radians(90.0)), 500);
    EXPECT_DOUBLE_EQ(split_distance(2, 4, 500, glm::radians(90.0)), 125);
    const double errors[] = {4, 1, 0.25};
    EXPECT_DOUBLE_EQ(skirt_depth(errors, 2), 1.25);
    EXPECT_DOUBLE_EQ(skirt_depth(errors, 0), 8);
    // From 2 radii, the horizon is at 60 degrees. A point at height sqrt(2) is visible for another 45 degrees.
    EXPECT_FALSE(behind_horizon(2, glm::radians(59.0), 1, 1));
    EXPECT_TRUE(behind_horizon(2, glm::radians(61.0), 1, 1));
    EXPECT_FALSE(behind_horizon(2, glm::radians(104.0), 1, std::sqrt(2)));
    EXPECT_TRUE(behind_horizon(2, glm::radians(106.0), 1, std::sqrt(2)));
    EXPECT_FALSE(behind_horizon(0.5, glm::radians(179.0), 1, 1.01)) << "from within there is no horizon";
    EXPECT_FALSE(behind_horizon(0, 0, 1, 1));
}

TEST(Planet, BumpsAreAlikeOnAllFacesOfAMapAndInNoProbe) {
    const auto smooth = [](const char* view, const char* lit_by, const char* mapping, const char* probe) {
        return drawn("09", shot_of("09",
                                   {{"view", view},
                                    {"lit_by", lit_by},
                                    {"mapping", mapping},
                                    {"height", "0"},
                                    {"level", "0"},
                                    {"texels", "16"}},
                                   probe, {288, 192}));
    };
    const Image flat = smooth("faces", "bumps", "equal-angle", ""), plain = smooth("faces", "map", "equal-angle", "");
    // Each face has its own light from its upper left, so the bricks shade all alike: the ratio to the plain picture.
    double apart = 0;
    size_t bumpy = 0, of_faces = 0;
    for (int y = 0; y < 96; ++y)
        for (int x = 0; x < 96; ++x) {
            const auto shade = [&](int face, const Image& picture) {
                const float* const pixel = picture.pixel(x + face % 3 * 96, y + face / 3 * 96);
                return double(pixel[0] + pixel[1] + pixel[2]);
            };
            bumpy += std::abs(shade(0, flat) - shade(0, plain)) > 0.02;
            for (int face = 1; face < 6; ++face, ++of_faces)
                apart += std::abs(shade(face, flat) / shade(face, plain) - shade(0, flat) / shade(0, plain));
        }
    EXPECT_GT(bumpy, 3000u);
    EXPECT_LT(apart / double(of_faces), 0.05) << "0.025; it is 0.062 if one face is upside down";
    for (const char* mapping : {"equal-angle", "lat-long"})
        EXPECT_EQ(smooth("planet", "bumps", mapping, "normal").values,
                  smooth("planet", "map", mapping, "normal").values);
    EXPECT_EQ(smooth("patches", "bumps", "equal-angle", "level").values,
              smooth("patches", "map", "equal-angle", "level").values);
}

TEST(Planet, TheCaptionCountsSkirtsOnlyWhereTheyAreDrawn) {
    const auto caption = [](const char* skirts) {
        const Image picture = drawn("09", shot_of("09", {{"view", "patches"}, {"skirts", skirts}}, "", {800, 400}));
        return std::vector<float>(picture.pixel(0, 0), picture.pixel(0, 24));  // above the planet
    };
    EXPECT_NE(caption("on"), caption("off"));
}

}  // namespace
}  // namespace relief
