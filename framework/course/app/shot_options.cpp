#include "framework/course/app/shot_options.h"

#include <fmt/format.h>

#include "framework/core/base/error.h"
#include "framework/core/base/text.h"

namespace relief::app {
namespace {

void parse_camera(const std::string& text, Orbit& camera) {
    const struct {
        double& value;
        double min, max;
    } parts[] = {{camera.yaw, -36000, 36000},   {camera.pitch, -89, 89},      {camera.distance, 1e-3, 1e6},
                 {camera.target.x, -1e6, 1e6},  {camera.target.y, -1e6, 1e6}, {camera.target.z, -1e6, 1e6},
                 {camera.field_of_view, 1, 170}};
    const auto words = split(text, ',');
    bool good = words.size() == 3 || words.size() == 6 || words.size() == 7;
    for (size_t i = 0; good && i < words.size(); ++i) {
        const auto number = parse_number(words[i]);
        good = number && *number >= parts[i].min && *number <= parts[i].max;
        if (good) parts[i].value = *number;
    }
    if (!good)
        throw UsageError(
            fmt::format("--camera takes yaw,pitch,distance in degrees and metres (pitch -89 to 89, distance above 0), "
                        "optionally ,x,y,z of the point it looks at and ,field of view in degrees (1 to 170), not '{}'",
                        text));
}

std::pair<std::string, std::string> parse_setting(const std::string& text) {
    const size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0)
        throw UsageError(fmt::format("--set takes knob=value, not '{}'", text));
    return {text.substr(0, equals), text.substr(equals + 1)};
}

}  // namespace

glm::ivec2 parse_size(const std::string& text) {
    const auto parts = split(text, 'x');
    const auto side = [](const std::string& part) {
        const auto value = parse_int(part);
        return value && *value >= 1 && *value <= max_picture_side ? *value : 0;
    };
    if (parts.size() == 2 && side(parts[0]) && side(parts[1])) return {side(parts[0]), side(parts[1])};
    throw UsageError(fmt::format("--size takes WIDTHxHEIGHT from 1x1 to {0}x{0}, not '{1}'", max_picture_side, text));
}

void ShotOptions::options(CommandOptions& options) {
    options.values("--set", "KNOB=VALUE", set_, "set a knob; may be repeated");
    options.value("--camera", "YAW,PITCH,DISTANCE[,X,Y,Z[,V]]", camera_,
                  "degrees and metres; X,Y,Z: the point it looks at; V: its field of view");
}

void ShotOptions::apply(Shot& shot) const {
    if (!camera_.empty()) parse_camera(camera_, shot.camera);
    for (const std::string& setting : set_) shot.set.push_back(parse_setting(setting));
}

}  // namespace relief::app
