// Requirements on every sweep of the topic `stability`.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>

#include "framework/core/base/error.h"
#include "framework/staff/measure/sweep.h"

namespace relief::measure {

/// Prepares all methods. Expects that the course's methods are finite and terminate at every place. Where a peer keeps
/// its stated error, one of the course's methods must keep a stated error that is no larger.
inline void expect_course_holds_where_peers_do(const std::vector<BenchScene>& scenes) {
    for (const BenchScene& scene : scenes) {
        const std::string name = knob_text(scene.knobs);
        std::vector<std::pair<std::string, BenchSweep>> ours, peers;
        for (const BenchMethod& method : scene.methods)
            (method.peer ? peers : ours).emplace_back(method.name, method.prepare().sweep.value());
        for (const auto& [method, sweep] : ours)
            for (const BenchSweep::Place& place : sweep.places) {
                EXPECT_EQ(place.not_finite, 0) << name << ", " << method << " at " << place.hardness;
                EXPECT_EQ(place.endless, 0) << name << ", " << method << " at " << place.hardness;
            }
        for (const auto& [method, sweep] : peers)
            for (size_t i = 0; i < sweep.places.size(); ++i) {
                const bool kept = std::any_of(ours.begin(), ours.end(), [&, stated = sweep.stated](const auto& one) {
                    return one.second.stated <= stated && holds(one.second, one.second.places[i]);
                });
                EXPECT_TRUE(kept || !holds(sweep, sweep.places[i]))
                    << name << ": " << method << " holds at " << sweep.places[i].hardness << ", and nothing of ours";
            }
    }
}

}  // namespace relief::measure
