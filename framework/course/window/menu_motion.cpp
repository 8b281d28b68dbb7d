#include "framework/course/window/menu_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "framework/core/base/text.h"
#include "framework/core/lab/knobs.h"
#include "framework/core/lab/lab.h"
#include "framework/course/window/menu_stage.h"

namespace relief::window {
namespace {

constexpr double degrees_per_second = 30, seconds_per_range = 8;
constexpr double longest_step = 0.2;  // seconds: a slow frame must not jump

}  // namespace

void Motion::advance(Stage& stage, double seconds) {
    if (!is_on() || !stage.lab()) return;
    const double step = std::clamp(seconds, 0.0, longest_step);
    if (turns_) stage.camera().yaw = std::remainder(stage.camera().yaw + degrees_per_second * step, 360);
    for (const KnobText& knob : slider_.empty() ? std::vector<KnobText>() : describe_knobs(*stage.lab())) {
        if (knob.name != slider_) continue;
        const double low = double(knob.low), high = double(knob.high), range = high - low;
        double moved = parse_number(knob.value).value_or(low) + direction_ * range * step / seconds_per_range;
        if (range == 360) {  // a full turn begins again; else a slider turns round at the ends of its range
            if (moved > high) moved -= range;
        } else if (moved > high || moved < low) {
            direction_ = moved > high ? -1 : 1;
        }
        set_knob(*stage.lab(), slider_, fmt::format("{}", float(std::clamp(moved, low, high))));
    }
    stage.changed();
}

}  // namespace relief::window
