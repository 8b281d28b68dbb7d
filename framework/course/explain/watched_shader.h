// Rewrites shaders to watch every function of a task file. A wrapper of the same name calls the function and notes the
// inputs and results of one call. It also calls the function's twin, the staff's copy in double precision, with the
// same inputs. Uniforms choose the note, and the fragment stage writes it in place of the picture. Needs no GL.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "framework/core/base/code_text.h"
#include "framework/core/gl/shader_source.h"

namespace relief::check {

/// The staff's copy of a task file in double precision. Its types are given by twin_type(), and every name that the
/// file itself defines ends in twin_suffix. RELIEF_FRAGMENT_STAGE is defined in stages with derivatives.
struct TwinText {
    std::string declarations;          ///< structs, constants and prototypes; go before the task's first function
    std::string functions;             ///< go at the end of the stage, where everything is declared
    std::set<std::string> signatures;  ///< signatures of the functions in the task file
};
constexpr const char* twin_suffix = "_relief_twin";
/// Returns the type of a twin's value: "dvec3" for "vec3", "dmat3x2" for "mat3x2", "ReliefRay_relief_twin" for a struct
/// of `structs`. Types without floats stay unchanged.
std::string twin_type(const std::string& type, const std::set<std::string>& structs);

/// Twins by task file, relative to the course's top folder.
using Twins = std::map<std::string, TwinText>;

/// The type of a value as a tree: a number, or a vector, matrix, array or struct of values.
struct ValueShape {
    enum Kind { number, whole, truth, texture, group };
    std::string name = {};  ///< name of a parameter or field, else empty
    Kind kind = number;
    std::vector<ValueShape> parts = {};

    /// Returns the count of numbers; 0 for a texture.
    size_t count() const;
};

struct WatchedFunction {
    enum Stage { vertex, control, evaluation, geometry, fragment };
    std::string name, signature;
    Place place;
    Stage stage = fragment;
    std::vector<ValueShape> inputs;
    std::vector<ValueShape> results;  ///< the return value (without a name), then the `out` parameters
    bool has_twin = false;

    size_t input_count() const;
    size_t result_count() const;
    /// Returns the size of a note, in floats.
    size_t note_size() const;
};
const char* name_of(WatchedFunction::Stage stage);

/// The floats at the start of a note: the number of calls, the noted one, its excess, and whether a task is unfinished.
/// Then come the inputs and the results. A function with a twin adds three numbers per result: the twin's result in
/// single precision, the rest that this rounds off, and the error bound of rounding.
constexpr size_t note_header = 4;
/// The number of floats of a note that the fragment stage writes at once: eight targets of four channels.
constexpr size_t note_slice = 32;

/// The uniforms of watched programs; all are 0 while nothing is noted.
namespace watched {
constexpr const char* noting = "u_relief_noting";      ///< 1 + the index of the written slice of the note
constexpr const char* function = "u_relief_function";  ///< 1 + the index of the function in the list of all functions
constexpr const char* stage = "u_relief_stage";        ///< the function's stage, see WatchedFunction::Stage
constexpr const char* call = "u_relief_call";          ///< index of the call; -1: the call furthest from its twin
/// How often the twin is called: once with the exact inputs, then with inputs perturbed as by rounding. 0: never.
constexpr const char* rounds = "u_relief_rounds";
constexpr int all_rounds = 7;
/// The results that callers get: 0: the functions' own; -1: the twins'; 1 + i: the twin's for function i only.
constexpr const char* flow = "u_relief_flow";
/// How many channels of each output are changed by 0.75 up or down, at random for each texel, inside of `region`: x and
/// y of the lower corner, then of the upper one, which is outside. 0: none.
constexpr const char* shaken = "u_relief_shaken";
constexpr const char* region = "u_relief_region";
}  // namespace watched

/// Rewrites the stages of a program. `functions` is one list for all programs; adds this program's functions to it if
/// they are missing. Returns the indices of this program's functions in the list. Returns none, and rewrites nothing,
/// for a program with a geometry stage, without a fragment stage, without watched functions, or without files.
std::vector<int> watch_functions(std::vector<ShaderSource>& stages, const std::set<std::filesystem::path>& task_files,
                                 const Twins& twins, std::vector<WatchedFunction>& functions);

}  // namespace relief::check
