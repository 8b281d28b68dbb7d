// Sweeps of relief bench that need a context: the searches of labs 10 to 12.
#include <map>

#include "framework/staff/measure/stability.h"
#include "tests/staff/measure/sweeps.h"

namespace relief::measure {
namespace {

TEST(Stability, HitsAreStableWherePeersAre) { expect_course_holds_where_peers_do(hit_sweeps({.quick = true})); }

/// Returns the verdicts of a scene's methods, by name.
std::map<std::string, BenchSweep> sweeps_of(const std::string& input) {
    std::map<std::string, BenchSweep> sweeps;
    for (const BenchScene& scene : hit_sweeps({.quick = true}))
        if (scene.knobs.front().second == input)
            for (const BenchMethod& method : scene.methods) sweeps[method.name] = method.prepare().sweep.value();
    return sweeps;
}

TEST(Stability, FloatUvLoseATexelAtTenThousandTilesUnlessWrapped) {
    const auto sweeps = sweeps_of("hits-tiles");
    const BenchSweep::Place exact = sweeps.at("windows").places[2], usual = sweeps.at("usual").places[2];
    ASSERT_EQ(exact.hardness, 1e4);
    EXPECT_LT(exact.error, 1e-3);
    EXPECT_GT(usual.error, 0.25) << "a float of 10,000 has steps of 1/1024: a quarter of a texel of 256";
    EXPECT_GT(sweeps.at("walk-with-a-nudge").places[2].endless, 0);
}

}  // namespace
}  // namespace relief::measure
