// Shader text in which every function of a task file is watched: a wrapper of the same name calls it, notes one call's
// inputs and result, and beside it calls the function's twin, the staff's copy in double precision, with the same
// inputs. Uniforms choose what is noted, and the fragment stage writes it in place of the picture. Needs no GL.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "framework/gl/glsl_text.h"
#include "framework/gl/shader_source.h"

namespace relief {

/// The staff's copy of a task file in double precision. Types are those of twin_type(), and every name that the file
/// itself defines ends in twin_suffix. RELIEF_FRAGMENT_STAGE is defined where there are derivatives.
struct TwinText {
    std::string declarations;          ///< structs, constants and prototypes: before the first function of the task
    std::string functions;             ///< at the end of the stage, where everything is declared
    std::set<std::string> signatures;  ///< of the functions, as the task file has them
};
constexpr const char* twin_suffix = "_relief_twin";
/// "dvec3" for "vec3", "mat3x2" for "dmat3x2", "ReliefRay_relief_twin" for a struct; what has no floats stays.
std::string twin_type(const std::string& type, const std::set<std::string>& structs);

/// By task file, relative to the course's top folder.
using Twins = std::map<std::string, TwinText>;

/// A value as a tree: a number, or a vector, matrix, array or struct of such.
struct ValueShape {
    enum Kind { number, whole, truth, texture, group };
    std::string name = {};  ///< of a parameter or a field, else empty
    Kind kind = number;
    std::vector<ValueShape> parts = {};

    /// How many numbers it has.
    size_t count() const;
};

struct WatchedFunction {
    enum Stage { vertex, control, evaluation, geometry, fragment };
    std::string name, signature;
    Place place;
    Stage stage = fragment;
    std::vector<ValueShape> inputs;
    std::vector<ValueShape> results;  ///< what it returns (without a name), then its `out` parameters
    bool has_twin = false;

    size_t input_count() const;
    size_t result_count() const;
    /// How many floats a note of it has.
    size_t note_size() const;
};
const char* name_of(WatchedFunction::Stage stage);

/// What a note begins with; then come the inputs, the results, and of each result the twin's, its rest in single
/// precision, and what rounding may cost.
struct NoteHeader {
    float calls, call, excess, is_unfinished;
};
constexpr size_t note_header = 4;
/// The fragment stage writes so many floats of a note at once: eight targets of four channels.
constexpr size_t note_slice = 32;

/// The uniforms of watched programs; all are 0 while nothing is noted.
namespace watched {
constexpr const char* noting = "u_relief_noting";      ///< 1 + the slice of the note that is written
constexpr const char* function = "u_relief_function";  ///< 1 + the place of the function among all
constexpr const char* stage = "u_relief_stage";        ///< the function's, see WatchedFunction::Stage
constexpr const char* call = "u_relief_call";          ///< which call; -1: the one that is furthest from its twin
/// How often the twin is called: once as it is, then with inputs that are moved as rounding might. 0: not at all.
constexpr const char* rounds = "u_relief_rounds";
constexpr int all_rounds = 7;
/// Whose results are used: 0 those of the functions, -1 those of the twins, 1 + i that of function i's twin.
constexpr const char* flow = "u_relief_flow";
}  // namespace watched

/// Rewrites the stages of a program. `functions` is one list for all programs; functions of this one that are not in it
/// are added. Returns the places in it of those that this program has.
std::vector<int> watch_functions(std::vector<ShaderSource>& stages, const std::set<std::filesystem::path>& task_files,
                                 const Twins& twins, std::vector<WatchedFunction>& functions);

}  // namespace relief
