// lab.toml, a lab's description for everyone, and staff/grading.toml, the part for staff only.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "framework/core/lab/registry.h"
#include "framework/core/lab/shot.h"
#include "framework/library/maps/visualize.h"

namespace relief {

/// A quantity that the lab's shaders can write. `error` tells how two values are compared. `limit` is an upper bound of
/// the error for 99 % of the pixels, with the manifest's camera and the default knobs. It allows only for single
/// precision, unless the lab is about methods with errors.
struct ProbeInfo {
    std::string name, unit;
    ErrorMetric error = ErrorMetric::distance;
    double limit = 1e-3;      ///< in the unit
    bool any_length = false;  ///< of a direction whose exact value is a unit vector: any other length is accepted
    bool is_signed = false;   ///< the sign of a value matters, and colours show it
    /// Knobs that take away the relief, such as strength = 0: the probe then shows the base that the relief changes.
    std::vector<std::pair<std::string, std::string>> without = {};
    ProbeColors colors() const { return {error, is_signed}; }
};

/// A task for students.
struct TaskInfo {
    std::string id, title, file;  ///< "11.2"; the file is relative to the course's top folder
    int points = 0;
    /// The functions that a student writes, as "crossing(float, float)": their names and the types of their parameters
    /// stay. Everything else in the file is the student's to change.
    std::vector<std::string> functions = {};
    /// Its points are not part of the lab's maximum. They make up for points that other tasks lost.
    bool optional = false;
};
/// Returns whether a task's file is a shader; else it is C++.
inline bool is_shader(const std::string& file) { return file.ends_with(".glsl"); }

/// Limits of a check for the error between two shots, in the probe's unit, over the pixels with a surface. A missing
/// limit allows any error.
struct Limits {
    std::optional<double> mean, p99, largest;
    std::optional<double> at_least;  ///< lower bound of the mean: a smaller error means that another method was used
    std::optional<double> wrong;     ///< share of the pixels with an error of more than one unit
    double outline = 0.01;           ///< share of the pixels where only one of the two has a surface
};

/// A comparison that decides whether a task is solved. A picture without its own `limits` passes if at most 0.05 % of
/// its pixels differ by more than 2/255, and at most 4 pixels by more than 32/255.
struct CheckInfo {
    std::string task, name;
    Shot shot;
    std::string against;  ///< "truth" of the probe, "solution" (its picture or probe), or the name of another check
    Limits limits;
    std::string reason;   ///< origin of the limits
    std::string look_at;  ///< where to look next when it fails
    bool hidden = false;  ///< from the staff's file: students never get it
    bool added = false;   ///< by add_grading(), to a task whose other checks all read a probe
    /// The other tasks without which the check cannot pass.
    std::vector<std::string> needs = {};
    /// Other tasks that may be unwritten, but that spoil the check if they are wrong.
    std::vector<std::string> leans_on = {};
    bool depends_on(const std::string& other_task) const;
};

/// A change to a file. Precondition: `find` occurs in it exactly once.
struct Edit {
    std::string file, find, replace;
};

/// A known mistake, as edits of the solution. With them, a check of its task must fail.
struct MistakeInfo {
    std::string id, task, hint;
    std::vector<Edit> edits;
    std::string same_as;  ///< another mistake that no check can distinguish from this one, or empty
};

/// Something that the text of a task asks for, with calls of the task's functions that tell whether it is so. The
/// public examples of a task form one public check, and the hidden ones another. The expected values are the
/// solution's.
struct ExampleInfo {
    std::string task;
    std::string asks;                ///< words of the task's text
    std::vector<std::string> calls;  ///< expressions; each results in a number, a bool or a vector of up to 4 numbers
    double within = 1e-4;            ///< limit of a component's error; relative where the right value is above 1
    std::vector<std::string> needs = {};  ///< the other tasks whose functions the calls use
    bool hidden = false;                  ///< from the staff's file
    /// Of the solution, so that at least one of the calls returns something else. Empty in the students' course, and
    /// for a hidden example with the words of a public one, which has them.
    std::vector<Edit> edits = {};
};

/// A knob that differs in hidden views: in a range, or among several values.
struct VaryInfo {
    std::string knob;
    double low = 0, high = 0;
    std::vector<std::string> choices = {};
};

/// A correct variant of a solution, as edits of it. With them, every task of the lab gets all its points.
struct EquivalentInfo {
    std::string id, task;
    std::string why;          ///< how it differs from the solution
    std::vector<Edit> edits;  ///< only of files that tasks name, because a submission contains no others
};

/// A question about what a lab teaches, for what no picture of a known mistake can ask.
struct QuestionInfo {
    std::string asks, right;
    std::vector<std::string> wrong;  ///< two or more answers
    std::string why;                 ///< said with the right answer
};

/// The comparison on a lab's page: one shot for each value of a knob.
struct CompareInfo {
    static constexpr glm::ivec2 usual_size{560, 420};
    std::string knob;
    std::vector<std::string> values;  ///< as for --set; empty: all values of a choice or a toggle
    Shot shot;                        ///< its probe is the one whose error is shown; empty: no error is shown
};

/// A reference screenshot, labs/<the lab's folder>/golden/<name>.png. For a probe, it is the result of
/// visualize_probe().
struct GoldenInfo {
    std::string name;
    Shot shot;
};

struct Manifest {
    std::string title;
    std::vector<std::string> learns;
    double hours = 0;                           ///< estimated time of a third-year student; 0: unknown
    std::vector<std::string> needs = {};        ///< labs whose ideas this one uses, as "04"
    std::vector<std::string> mathematics = {};  ///< what a student must know of it
    std::vector<std::string> leave_out = {};    ///< chapters of the handout that a first reading can omit
    bool elective = false;                      ///< no other lab needs it
    std::map<std::string, int> weeks = {};      ///< the week of this lab in each path that has it, see course_paths
    Orbit camera;
    bool animated = false;
    /// Files below `shaders` that the shader of a task may include, besides common/unfinished.glsl.
    std::vector<std::string> task_includes;
    std::vector<ProbeInfo> probes;
    std::vector<TaskInfo> tasks;
    std::vector<CheckInfo> checks;
    std::vector<MistakeInfo> mistakes;
    std::vector<ExampleInfo> examples;
    std::vector<std::string> example_includes;  ///< see Calls::includes
    std::vector<VaryInfo> vary;
    std::vector<EquivalentInfo> equivalents;
    std::vector<QuestionInfo> questions;
    std::optional<CompareInfo> compare;
    std::vector<GoldenInfo> goldens;
    /// Name of the reference screenshot that stands for the lab among other labs: one scene without captions. The first
    /// one if the manifest names none; empty if there is none.
    std::string cover;

    int points() const;           ///< the maximum: of the tasks that are not optional
    int optional_points() const;  ///< of the optional tasks
    // These throw UsageError that suggests the nearest name.
    const ProbeInfo& probe(const std::string& name) const;
    const TaskInfo& task(const std::string& id) const;
    const CheckInfo& check(const std::string& name) const;
    /// Returns a check's shot. Also throws for a check that calls functions instead of drawing a view.
    const Shot& view_of_check(const std::string& name) const;
    const MistakeInfo& mistake(const std::string& id) const;
    const GoldenInfo& golden(const std::string& name) const;
};

/// Reads a lab.toml, and staff/grading.toml beside it if it exists. Throws Error with file and line for a missing file
/// or a syntax error, for an unknown or missing key, and for a value of another type or out of range. Also throws for a
/// duplicate name, and for a reference to a missing probe, task, check or mistake.
Manifest load_manifest(const std::filesystem::path& file);
/// Parses the text of a lab.toml alone. `file` appears in messages only.
Manifest parse_manifest(const std::string& text, const std::filesystem::path& file);
/// The name of the probe of ExampleInfo::calls. No lab has a probe with this name.
inline constexpr const char* calls_probe = "calls";

/// Adds the text of a staff/grading.toml: hidden checks, mistakes, equivalents, questions, hidden examples, edits of
/// the public examples, and knobs that vary. Each task whose checks all read a probe gets a hidden check more: the
/// picture of its first check must be the solution's. Otherwise a submission could be right in the probe, and wrong in
/// the picture that a person sees.
void add_grading(Manifest& manifest, const std::string& text, const std::filesystem::path& file);
Manifest load_manifest(const LabEntry& lab);

}  // namespace relief
