// Shots of a lab with somebody's files in place of its tasks': staged, compiled and drawn in the sandbox.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "framework/check/check.h"
#include "framework/check/drawing.h"
#include "framework/staff/grade/stage.h"

namespace relief {

/// What came of one shot.
struct DrawnAttempt {
    std::optional<Image> image;
    Outcome outcome = Outcome::broken;  ///< where there is no image
    std::string error;                  ///< one line, see printable()
    bool told = false;                  ///< the error came from the lab as it drew
};

struct Attempt {
    std::vector<DrawnAttempt> shots;  ///< one for each that was asked for
    double compile = 0, draw = 0;     ///< seconds
    std::string log;                  ///< what a compiler said at length, or empty
};

struct AttemptLimits {
    double seconds = 120;             ///< for drawing once; twice that in all, and three times that for compiling
    size_t memory = size_t{2} << 30;  ///< bytes of addresses
};

/// The lab must have been added to the stage. A process that dies takes the shot it was at with it; the others are
/// drawn by another. The shots from `apart` on are asked of other processes than those before where a C++ task could
/// say what it was asked for; their log is not kept. Never throws for what the files do.
Attempt attempt(const Stage& stage, const LabEntry& lab, const CourseFiles& files, const std::vector<Shot>& shots,
                const Renderer& renderer, const AttemptLimits& limits, size_t apart = size_t(-1));

}  // namespace relief
