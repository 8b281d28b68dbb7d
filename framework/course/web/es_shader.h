// GLSL ES 3.00, the language of WebGL 2, from the GLSL 4.10 of the course. Needs no GL.
#pragma once

#include <string>
#include <vector>

namespace relief::web {

enum class EsStage { vertex, fragment };

/// SwiftShader and GPUs do not end a loop, and a browser that waits for one cannot even reload the page.
inline constexpr int most_rounds = 1 << 13;

/// Returns a stage in GLSL ES 3.00. Every line keeps its number in the compiler's messages. `text` is a stage after all
/// #include, and begins with its #version line.
/// - Functions that ES lacks are defined in front of the text if it calls them: see missing_functions().
/// - Outputs of a vertex stage that are whole numbers become `flat`, as ES wants.
/// - Doubles become floats.
/// - A vertex stage adds `uniform vec2 relief_move`, in clip space, to each position.
/// - The loops of `task`, the text of a task file, and of its macros have most_rounds rounds together in each
///   invocation, so that an endless one ends. A loop that counts to a constant stays as it is: a compiler may have to
///   unroll it. So do those that declare a variable in their condition, and a `while` in a macro whose condition
///   follows outside of the macro.
/// - `precise` and the declared direction of gl_FragDepth are dropped, as are #extension lines.
std::string es_shader(const std::string& text, EsStage stage, const std::string& task = {});

/// A function of GLSL 4.10 that ES lacks, and definitions of it in ES.
struct MissingFunction {
    const char* name;
    const char* text;        ///< lines that also compile in GLSL 4.10 if the function has another name
    bool in_fragments_only;  ///< it needs derivatives
};

/// Returns the functions that es_shader() defines:
/// - textureGather, of a sampler2D that repeats, from level 0. A position within 1/512 of a texel's centre may give
///   another cell than the real function, as GPUs round it to 8 bits.
/// - textureQueryLod, of a sampler2D, for an isotropic filter: log2 of the longer of both derivatives, in texels. The
///   logarithm is Mesa's: linear between powers of two, at most 0.043 too small. It drew the expected pictures.
/// - findMSB and bitCount, exactly.
/// - fma, of floats and their vectors, rounded twice.
const std::vector<MissingFunction>& missing_functions();

/// Explains a compiler's messages about implicit conversions, which GLSL 4.10 has and ES lacks: adds "in a browser,
/// write 2.0 instead of 2" to each of their lines.
std::string es_log(const std::string& log);

}  // namespace relief::web
