// The options that `relief shot` and `relief run` share: knobs and the camera.
#pragma once

#include <string>
#include <vector>

#include "framework/app/command.h"
#include "framework/lab/shot.h"

namespace relief {

/// What --size takes, "640x360", in pixels. Throws UsageError.
glm::ivec2 parse_size(const std::string& text);

class ShotOptions {
public:
    void options(CommandOptions& options);
    /// Sets in the shot what was given. Throws UsageError.
    void apply(Shot& shot) const;

private:
    std::vector<std::string> set_;
    std::string camera_;
};

}  // namespace relief
