#include "framework/course/app/shot_options.h"

#include <fmt/format.h>

#include "framework/core/base/error.h"
#include "framework/core/base/log.h"
#include "framework/core/base/text.h"

namespace relief::app {
namespace {

void parse_camera(const std::string& text, Orbit& camera) {
    const struct {
        const char* name;
        double& value;
        double min, max;
    } parts[] = {{"yaw, in degrees", camera.yaw, -36000, 36000},
                 {"pitch, in degrees", camera.pitch, -89, 89},
                 {"distance, in metres", camera.distance, 1e-3, 1e6},
                 {"x of the point it looks at, in metres", camera.target.x, -1e6, 1e6},
                 {"y of the point it looks at, in metres", camera.target.y, -1e6, 1e6},
                 {"z of the point it looks at, in metres", camera.target.z, -1e6, 1e6},
                 {"field of view, in degrees", camera.field_of_view, 1, 170}};
    const auto words = split(text, ',');
    if (words.size() != 3 && words.size() != 6 && words.size() != 7)
        throw UsageError(
            fmt::format("--camera takes yaw,pitch,distance in degrees and metres, optionally ,x,y,z of the point it "
                        "looks at and ,field of view in degrees, not '{}'",
                        text));
    for (size_t i = 0; i < words.size(); ++i) {
        const auto& part = parts[i];
        const auto number = parse_number(words[i]);
        if (!number || *number < part.min || *number > part.max)
            throw UsageError(fmt::format("--camera {}: the {}, is a number from {} to {}, not '{}'", text, part.name,
                                         rounded(part.min), rounded(part.max), words[i]));
        part.value = *number;
    }
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

void ShotOptions::note_knobs_without_effect(Lab& lab) const {
    const std::vector<KnobText> knobs = describe_knobs(lab);
    for (const std::string& setting : set_) {
        const std::string name = parse_setting(setting).first;
        if (const std::string condition = unmet_condition(name, knobs); !condition.empty())
            print_note(fmt::format("{} has no effect here, only for {}", name, condition));
    }
}

}  // namespace relief::app
