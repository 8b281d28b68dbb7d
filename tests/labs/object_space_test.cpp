// Lab 04: which map stays valid under which motion.
#include <algorithm>
#include <cmath>

#include "tests/labs/shots.h"

namespace relief {
namespace {

TEST(ObjectSpace, EachMapSurvivesExactlyItsOwnMotions) {
    const std::pair<Knob, const char*> motions[] = {{{"twist", "60"}, "tangent"},
                                                    {{"rotate", "60"}, "object tangent"},
                                                    {{"translate", "0.3"}, "world object tangent"}};
    int cells = 0;
    for (const auto& [motion, survivors] : motions)
        for (const char* map : {"world", "object", "tangent"}) {
            const Shot shot =
                shot_of("04", {{"view", "one"}, {"twist", "0"}, {"map", map}, motion}, "normal", {256, 256});
            const double mean = error_of("04", shot).mean;
            if (std::string(survivors).find(map) != std::string::npos)
                EXPECT_LT(mean, 1.5) << map << " under " << motion.first;
            else
                EXPECT_GT(mean, 10) << map << " under " << motion.first;
            ++cells;
        }
    EXPECT_EQ(cells, 9);
}

/// Returns a third of the picture of the view `baked`, from the left: baked light, the world-space map, the
/// tangent-space map.
Image baked_view(std::vector<Knob> knobs, int third) {
    knobs.insert(knobs.end(), {{"view", "baked"}, {"show_map", "off"}});
    const Image whole = drawn("04", shot_of("04", knobs, "", {384, 128}));
    Image part(128, 100, 3);  // without the caption
    for (int y = 0; y < part.height; ++y) std::copy_n(whole.pixel(128 * third, y + 28), 3 * 128, part.pixel(0, y));
    return part;
}

double mean_difference(const Image& a, const Image& b) {
    double sum = 0;
    for (size_t i = 0; i < a.values.size(); ++i) sum += std::abs(double(a.values[i]) - double(b.values[i]));
    return sum / double(a.values.size());
}

TEST(ObjectSpace, BakedLightIsRightForItsLampAndPoseOnly) {
    const auto off = [](const std::vector<Knob>& knobs) {
        return mean_difference(baked_view(knobs, 0), baked_view(knobs, 2));
    };
    const double at_rest = off({{"twist", "0"}});
    EXPECT_LT(at_rest, 0.01) << "light is filtered here, and normals are filtered there";
    EXPECT_GT(off({{"twist", "0"}, {"light_yaw", "-60"}}), 5 * at_rest);
    EXPECT_GT(off({{"twist", "0"}, {"rotate", "60"}}), 5 * at_rest);
}

TEST(ObjectSpace, BakedLightIgnoresTheLampAndAWorldSpaceMapFollowsIt) {
    const auto moved = [](int third) {
        return mean_difference(baked_view({{"light_yaw", "-60"}}, third), baked_view({{"light_yaw", "40"}}, third));
    };
    EXPECT_EQ(moved(0), 0);
    EXPECT_GT(moved(1), 0.02);
}

TEST(ObjectSpace, LightIsBakedOnce) {
    Shot shot = shot_of("04", {{"view", "baked"}});
    const auto lab = make_lab(find_lab("04"), shot);
    const auto draws = [&] { return work_of(*lab, shot).draws; };
    const int64_t first = draws();
    set_knob(*lab, "light_yaw", "90");
    EXPECT_EQ(draws(), first - 1);
}

TEST(ObjectSpace, AtRestTheThreeMapsAgree) {
    Shot shot = shot_of("04", {{"view", "one"}, {"twist", "0"}, {"map", "world"}}, "normal");
    shot.camera.distance = 1.3;
    const Image world = drawn("04", shot);
    for (const char* map : {"object", "tangent"}) {
        shot.set.back().second = map;
        const ErrorSummary off = summarize(error_image(drawn("04", shot), world, ErrorMetric::angle));
        // Each map is rounded to 8 bits: 0.17 degrees on average for one map, sqrt(2) times that for the difference.
        // Also, the filter mixes unit vectors of different spaces.
        EXPECT_LT(off.mean, 0.35) << map;
        EXPECT_GT(off.mean, 0.05) << map << ": is it the same map?";
    }
}

}  // namespace
}  // namespace relief
