// lab.toml: a lab's description for everybody; staff/grading.toml: the part for staff only.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "framework/image/visualize.h"
#include "framework/lab/registry.h"
#include "framework/lab/shot.h"

namespace relief {

/// A quantity that the lab's shaders can write. `error` is how two values of it are compared, and `limit` what 99 % of
/// the pixels keep, by the manifest's camera and the knobs as they are: no more than single precision costs, unless the
/// lab is about methods that are wrong.
struct ProbeInfo {
    std::string name, unit;
    ErrorMetric error = ErrorMetric::distance;
    double limit = 1e-3;      ///< in the unit
    bool any_length = false;  ///< of a direction: where the exact one has unit length, others may do without
    bool is_signed = false;   ///< it matters that a value is above or below 0, and colours show it
    ProbeColors colors() const { return {error, is_signed}; }
};

/// A task for students.
struct TaskInfo {
    std::string id, title, file;  ///< "11.2"; the file is relative to the course's top folder
    int points = 0;
    /// It is marked with the solution of the other tasks where it loses points with the student's own.
    bool alone = true;
};
/// Whether a task's file is a shader, and not C++.
inline bool is_shader(const std::string& file) { return file.ends_with(".glsl"); }

/// What a check allows between two shots; nothing where a limit is not given. In the unit of the probe, over the pixels
/// with a surface.
struct Limits {
    std::optional<double> mean, p99, largest;
    std::optional<double> at_least;  ///< of the mean: what is nearer to the truth was not worked out as asked
    std::optional<double> wrong;     ///< share of the pixels that are off by more than one unit
    double outline = 0.01;           ///< share of the pixels in which only one of the two has a surface
};

/// A comparison that decides whether a task is solved. A picture without its own `limits` may have 0.05 % of its
/// pixels off by more than 2/255, and 4 pixels by more than 32/255.
struct CheckInfo {
    std::string task, name;
    Shot shot;
    std::string against;  ///< "truth" of the probe, "solution" (its picture or probe), or the name of another check
    Limits limits;
    std::string reason;   ///< where the limits come from
    std::string look_at;  ///< what to look at next when it fails
    bool hidden = false;  ///< of the staff's file: never handed out
    /// The other tasks without which it cannot pass.
    std::vector<std::string> needs = {};
    /// Those that it can do without while they are not written, and that spoil it when they are wrong.
    std::vector<std::string> leans_on = {};
    bool depends_on(const std::string& other_task) const;
};

/// A change to a file: `find` stands in it exactly once.
struct Edit {
    std::string file, find, replace;
};

/// A known mistake, as edits of the solution: a check of its task must fail with them.
struct MistakeInfo {
    std::string id, task, hint;
    std::vector<Edit> edits;
    std::string same_as;  ///< another mistake that no check can distinguish from this one, or empty
};

/// A knob that differs in hidden views: within a range, or one of several values.
struct VaryInfo {
    std::string knob;
    double low = 0, high = 0;
    std::vector<std::string> choices = {};
};

/// A correct variant of a solution, as edits of it: with them every task of the lab has all its points.
struct EquivalentInfo {
    std::string id, task;
    std::string why;          ///< what it does differently
    std::vector<Edit> edits;  ///< of files that tasks name: no other is taken from a submission
};

/// The comparison on a lab's page: one shot for each value of a knob.
struct CompareInfo {
    static constexpr glm::ivec2 usual_size{560, 420};
    std::string knob;
    std::vector<std::string> values;  ///< as --set takes them; empty: all that a choice or a toggle has
    Shot shot;                        ///< its probe is the one whose error is shown; or none
};

/// A reference screenshot, labs/<the lab's folder>/golden/<name>.png; of a probe, what visualize_probe() makes of it.
struct GoldenInfo {
    std::string name;
    Shot shot;
};

struct Manifest {
    std::string title;
    std::vector<std::string> learns;
    Orbit camera;
    bool animated = false;
    /// Below `shaders`: what the shader of a task may include besides common/unfinished.glsl.
    std::vector<std::string> task_includes;
    std::vector<ProbeInfo> probes;
    std::vector<TaskInfo> tasks;
    std::vector<CheckInfo> checks;
    std::vector<MistakeInfo> mistakes;
    std::vector<VaryInfo> vary;
    std::vector<EquivalentInfo> equivalents;
    std::optional<CompareInfo> compare;
    std::vector<GoldenInfo> goldens;

    int points() const;
    // These throw UsageError that suggests the nearest.
    const ProbeInfo& probe(const std::string& name) const;
    const TaskInfo& task(const std::string& id) const;
    const CheckInfo& check(const std::string& name) const;
    const MistakeInfo& mistake(const std::string& id) const;
};

/// Reads a lab.toml, and staff/grading.toml beside it where there is one. Throws Error with file and line for a missing
/// file, a syntax error, an unknown or missing key, a value of another type or out of range; for a name that is used
/// twice, and for one (of a probe, a task, a check, a mistake) that is not there.
Manifest load_manifest(const std::filesystem::path& file);
/// Of the text of a lab.toml alone; `file` is only named.
Manifest parse_manifest(const std::string& text, const std::filesystem::path& file);
/// What the text of a staff/grading.toml adds: hidden checks, mistakes, equivalents, and what varies.
void add_grading(Manifest& manifest, const std::string& text, const std::filesystem::path& file);
Manifest load_manifest(const LabEntry& lab);

}  // namespace relief
