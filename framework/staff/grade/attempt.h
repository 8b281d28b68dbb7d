// Draws shots of a lab in the sandbox, with a submission's files in place of the task files.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "framework/course/check/check.h"
#include "framework/course/check/guarded_drawing.h"
#include "framework/staff/grade/stage.h"

namespace relief::grade {

/// The result of one shot.
struct DrawnAttempt {
    std::optional<Image> image;
    check::Outcome outcome = check::Outcome::broken;  ///< only if there is no image
    std::string error;                                ///< one line, see printable()
    bool told = false;                                ///< the lab itself sent the image or the error
    bool ran_out = false;                             ///< the time ran out while it was drawn, not before
    double cpu = 0;  ///< seconds of processor time if `told`, as the process reports them
};

struct Attempt {
    std::vector<DrawnAttempt> shots;  ///< one for each requested shot
    double compile = 0, draw = 0;     ///< seconds
    /// If the compiler or a shot is out of time: the wall time for compiling and drawing, in units of its limit.
    double wasted = 0;
    bool compiles_forever = false;  ///< the compiler needs more time or memory than is allowed
    double cpu = 0;                 ///< seconds of processor time for drawing, as reported: see DrawnShots
    std::string log;                ///< the compiler's messages, or empty
    /// The compiled shaders of the last process, with those that it got; only if `keeps_compiled`. They are as
    /// trustworthy as the files.
    check::CompiledShaders compiled;
};

struct AttemptLimits {
    /// Seconds of processor time for one drawing process. All processes together have twice that.
    double cpu = 120;
    size_t memory = size_t{2} << 30;  ///< bytes of address space
    /// Returns the compiler's limit of processor time, in seconds.
    double compile_cpu() const { return std::max(10.0, 1.5 * cpu); }
    /// Returns the limit of wall time, in seconds: for all drawing processes together, and for the compiler. It is
    /// loose, and stops processes that wait instead of computing: on a busy machine, only processor time is a fair
    /// limit.
    double wall() const { return 3 * cpu; }
};

/// Draws `shots` of a lab that was added to the stage. If a process dies, the shot that it was drawing fails, and
/// another process draws the remaining shots. If the process ran out of time, the remaining shots are out of time, too.
/// A C++ task could reveal the shots that it was asked to draw. So a separate process draws the shots from index
/// `apart` on, and its log is not kept. Failures of the files become outcomes, not exceptions.
///
/// A process that dies loses its compiled shaders. The next one starts with those that the last complete process of
/// this attempt returned, or else with `known`. Both processes of a C++ task run the same files, so one can tell the
/// other nothing that it does not know. `alone`: see Stage::course().
Attempt attempt(const Stage& stage, const LabEntry& lab, const CourseFiles& files, const std::vector<Shot>& shots,
                const check::Renderer& renderer, const AttemptLimits& limits, size_t apart = size_t(-1),
                const check::CompiledShaders& known = {}, bool keeps_compiled = false, const std::string& alone = {});

/// Returns the calls of the functions in `files` at some pixels of `shots`, see check::lone_calls(). They run in the
/// sandbox like attempt(), in one process. A shot that is not finished within the limits has no pixels.
check::NotedCalls note_calls(const Stage& stage, const LabEntry& lab, const CourseFiles& files,
                             const std::vector<check::NotedShot>& shots, const check::Renderer& renderer,
                             const AttemptLimits& limits);

}  // namespace relief::grade
