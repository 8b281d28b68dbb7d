// The options that `relief shot` and `relief run` share: knobs and the camera.
#pragma once

#include <string>
#include <vector>

#include "framework/core/lab/shot.h"
#include "framework/course/app/command.h"

namespace relief::app {

/// Parses the value of --size, such as "640x360", in pixels. Throws UsageError.
glm::ivec2 parse_size(const std::string& text);

class ShotOptions {
public:
    void options(CommandOptions& options);
    /// Applies the given options to the shot. Throws UsageError.
    void apply(Shot& shot) const;
    /// Prints a note for each knob of --set that has no effect in this lab as it is set now.
    void note_knobs_without_effect(Lab& lab) const;

private:
    std::vector<std::string> set_;
    std::string camera_;
};

}  // namespace relief::app
