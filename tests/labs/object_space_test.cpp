// Lab 04: which map stays valid under which motion.
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
