// The options that `relief shot` and `relief run` share: knobs and the camera.
#pragma once

#include <string>
#include <vector>

#include "framework/app/command.h"
#include "framework/lab/shot.h"

namespace relief {

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
