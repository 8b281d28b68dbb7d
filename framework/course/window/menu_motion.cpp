#include "framework/course/window/menu_motion.h"

#include <algorithm>
#include <cmath>

#include "framework/core/lab/knobs.h"
#include "framework/core/lab/lab.h"
#include "framework/course/window/menu_stage.h"

namespace relief::window {
namespace {

constexpr double degrees_per_second = 30, seconds_per_range = 8;
constexpr double longest_step = 0.2;  // seconds: a slow frame must not jump

/// Moves one slider on. At the end of its range it turns round; a full turn of 360 degrees begins again.
class MoveSlider final : public Knobs {
public:
    MoveSlider(const std::string& name, double seconds, double& direction)
        : name_(name), seconds_(seconds), direction_(direction) {}

    void slider(const char* name, float& value, float low, float high, const KnobHelp&) override {
        if (name_ != name) return;
        const double range = double(high) - double(low);
        double moved = double(value) + direction_ * range * seconds_ / seconds_per_range;
        if (range == 360) {
            if (moved > double(high)) moved -= range;
        } else if (moved > double(high) || moved < double(low)) {
            direction_ = moved > double(high) ? -1 : 1;
        }
        value = float(std::clamp(moved, double(low), double(high)));
    }
    void steps(const char*, int&, int, int, const KnobHelp&) override {}
    void toggle(const char*, bool&, const KnobHelp&) override {}
    void choice(const char*, int&, std::span<const char* const>, const KnobHelp&) override {}

private:
    const std::string& name_;
    double seconds_;
    double& direction_;
};

}  // namespace

void Motion::advance(Stage& stage, double seconds) {
    if (!is_on() || !stage.lab()) return;
    const double step = std::clamp(seconds, 0.0, longest_step);
    if (turns_) stage.camera().yaw = std::remainder(stage.camera().yaw + degrees_per_second * step, 360);
    if (!slider_.empty()) {
        MoveSlider move(slider_, step, direction_);
        stage.lab()->knobs(move);
    }
    stage.changed();
}

}  // namespace relief::window
