// One pixel of a lab, through the functions of its shader task files: what each is called with and returns there,
// beside its twin in double precision, and the first that differs by more than rounding.
//
// The lab draws as ever; each of its draw calls is then made again for the one pixel, once for each value, into a
// target of floats (see watched_shader.h). So functions of all stages are seen, and those of earlier passes, too.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "framework/base/from_staff.h"
#include "framework/check/watched_shader.h"
#include "framework/lab/manifest.h"

namespace relief {

/// Twins of the course's own task files, by the staff's copy. Without them nothing is compared.
inline FromStaff<Twins(const Manifest&)> twins_of;

/// A function's call at the pixel. Numbers are in the order of the shapes; a truth is 1 or 0.
struct ExplainedCall {
    int number = 0;  ///< from 0
    std::vector<float> inputs = {}, results = {};
    std::vector<double> twin = {};    ///< empty if the function has none
    std::vector<float> allowed = {};  ///< how far rounding may put each result from the twin's
    double excess = 0;                ///< the largest distance from the twin, in what is allowed
    bool operator==(const ExplainedCall&) const = default;
};

struct ExplainedFunction {
    WatchedFunction function;
    /// The pass that called it: 0 draws the picture; the others draw what it reads, from 1 on in the order of drawing.
    int pass = 0;
    glm::ivec2 pixel{0};  ///< of that pass's target, row 0 at the top
    glm::ivec2 size{0};   ///< of that target
    int calls = 0;
    bool is_unfinished = false;
    std::vector<ExplainedCall> shown = {};  ///< first and last, and of those that differ the worst

    const ExplainedCall& worst() const;
    /// By more than rounding.
    bool differs() const { return function.has_twin && worst().excess > 1; }
};

struct Explanation {
    /// Callees before callers, earlier passes and stages before later ones. Passes that draw the same are listed once.
    std::vector<ExplainedFunction> functions;
    /// The first function that differs and without whose difference the pixel is another.
    std::optional<size_t> first;
    /// Whether the functions were called with what twins returned: as they are, nothing that differs was seen at the
    /// pixel, but it changes once twins take their places.
    bool with_twins = false;
    std::vector<float> value;  ///< of the pixel: the probe's, or red, green and blue from 0 to 1
};

/// Draws in the current context. `pixel`: column and row from the top. Throws UsageError for one outside of the shot,
/// and what the lab throws.
Explanation explain(const LabEntry& lab, const Manifest& manifest, const Shot& shot, glm::ivec2 pixel,
                    const Twins& twins);

}  // namespace relief
