// Shader text from files: #include, #define permutations, and the mapping of a compiler's messages back to source
// lines. Needs no GL.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "framework/core/base/error.h"

namespace relief {

struct ShaderSource {
    std::filesystem::path stage;
    std::string text;             ///< text for the compiler
    std::vector<Place> lines;     ///< source file and line of each line of the text; an inserted #define has no file
    std::set<std::string> names;  ///< every u_ and s_ name in the files, used or not
};

/// Reads a stage and the files that it includes. An included file such as `"common/light.glsl"` is searched for beside
/// the including file, then below the course's `shaders` folder. Each file is included once. `defines` ("NAME" or "NAME
/// VALUE") are inserted after the `#version` line, which must be the first line of the stage. Throws Error with file
/// and line, also for a fault_of_source().
ShaderSource load_shader(const std::filesystem::path& stage, const std::vector<std::string>& defines);
/// Returns the same for a stage whose plain_source() is in memory. `stage` is the file that it would be in.
ShaderSource load_shader_text(const std::string& text, const std::filesystem::path& stage,
                              const std::vector<std::string>& defines);

/// Returns the source without the functions that main() does not reach, without what its #if lines leave out
/// (base/conditions.h), without comments and empty lines, with the place of each line that is left. A driver keeps
/// compiled programs by their text, so a change of one function compiles only the programs that use it. A name in any
/// other preprocessor line counts. Code that parse_glsl() does not understand stays.
ShaderSource reached_source(const ShaderSource& source);

/// Returns the names in a text's own #include lines, as written. Skips malformed lines.
std::set<std::string> included_by(const std::string& text);

/// The first error of a compiler's or a linker's log, in terms of the source files: its place and its message with
/// advice. `text` is a folded_text(): the line of the source with a mark below the place, and the other messages. Each
/// "0:12(5): " or "0(12) : " is replaced by the file and line that line 12 of the compiled text (`source`) comes from.
///
/// GLSL could do this with a #line number per file, but Mesa 22.3 drops the file number from some messages, such as
/// "undeclared".
///
/// The advice is a name in scope, or of GLSL, that resembles an unknown one; GLSL's word for one of HLSL, C++ or
/// Python; a ; or a bracket that is missing. An error in another file gets a place in `task.glsl` if that ends in the
/// middle, or lacks, redefines or changes what the lab's shaders use.
struct ShaderLog {
    Place first;
    std::string first_message;
    std::string text;
};
ShaderLog explain_log(const std::string& log, const std::vector<Place>& lines, const std::string& source = {});

}  // namespace relief
