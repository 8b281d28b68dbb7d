// Explains one pixel of a lab through the functions of its shader task files. Shows the inputs and results of their
// calls, the results of their twins in double precision, and the first function that differs by more than rounding.
//
// The lab draws as usual. Each of its draw calls is then repeated for the one pixel, once per slice of a note, into a
// target of floats (see watched_shader.h). So functions of all stages are covered, and of earlier passes, too.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "framework/core/base/from_staff.h"
#include "framework/course/explain/watched_shader.h"
#include "framework/course/manifest/manifest.h"

namespace relief::check {

/// Provides the twins of the course's own task files; the staff's library fills it. Without twins nothing is compared.
inline FromStaff<Twins(const Manifest&)> twins_of;

/// A function's call at the pixel. Numbers are in the order of the shapes; a bool is 1 or 0.
struct ExplainedCall {
    int number = 0;  ///< counts from 0
    std::vector<float> inputs = {}, results = {};
    std::vector<double> twin = {};    ///< the twin's results; empty if the function has no twin
    std::vector<float> allowed = {};  ///< for each result, upper bound of its distance from the twin's through rounding
    double excess = 0;                ///< maximum distance from the twin, as a multiple of `allowed`
    /// Returns true for the same call, and for another one with the same inputs and results.
    bool has_values_of(const ExplainedCall& other) const {
        return number == other.number || (inputs == other.inputs && results == other.results);
    }
    bool operator==(const ExplainedCall&) const = default;
};

struct ExplainedFunction {
    WatchedFunction function;
    /// The pass that called it: 0 draws the picture; passes from 1 on draw its inputs, in the order of drawing.
    int pass = 0;
    glm::ivec2 pixel{0};  ///< in that pass's target; row 0 is at the top
    glm::ivec2 size{0};   ///< size of that target
    /// Whether that is a texel that the pixel reads. Of a pass that it does not read, it is the texel that is furthest
    /// from its twin.
    bool is_read = true;
    int calls = 0;
    bool is_unfinished = false;
    std::vector<ExplainedCall> shown = {};  ///< the first, the last, and the one that differs most, if one differs

    const ExplainedCall& worst() const;
    /// Returns whether a call differs from its twin by more than rounding.
    bool differs() const { return function.has_twin && worst().excess > 1; }
};

struct Explanation {
    /// Callees before callers, earlier passes and stages before later ones. Equal results of several passes are listed
    /// once.
    std::vector<ExplainedFunction> functions;
    /// The first function that differs and whose difference changes the pixel.
    std::optional<size_t> first;
    /// Whether twins replaced the functions to find `first`. Without them, no difference changed the pixel, but
    /// replacing all functions with their twins does.
    bool with_twins = false;
    std::vector<float> value;  ///< the pixel's value: the probe's, or red, green and blue in [0, 1]
};

/// Explains a pixel; draws in the current context. `pixel`: column and row from the top. Throws UsageError for a pixel
/// outside of the shot, and propagates errors of the lab.
Explanation explain(const LabEntry& lab, const Manifest& manifest, const Shot& shot, glm::ivec2 pixel,
                    const Twins& twins);

/// A call of a function whose result depends on its arguments alone, so that a person can compute it: see
/// lone_function(). Its numbers are rounded for people.
struct LoneCall {
    std::string name;                    ///< of the function
    std::string file;                    ///< relative to the course's top folder
    int line = 0;                        ///< of the function
    int number = 0, count = 1;           ///< the call at this pixel, counted from 0, and the number of its calls there
    std::vector<std::string> arguments;  ///< "height 0.73"
    std::vector<float> inputs;           ///< the rounded numbers of the arguments
    std::vector<float> results;          ///< the function's result there
    std::vector<float> again;            ///< its result for the rounded arguments
};

/// Returns for each pixel such calls in the fragment stage of the picture, or of a pass of the same size. Draws in the
/// current context. `files`: the shader task files, relative to the course's top folder. Precondition: the pixels are
/// inside of the shot.
std::vector<std::vector<LoneCall>> lone_calls(const LabEntry& lab, const std::set<std::string>& files, const Shot& shot,
                                              const std::vector<glm::ivec2>& pixels);

}  // namespace relief::check
