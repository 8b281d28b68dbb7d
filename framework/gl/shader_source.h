// Shader text from files: #include, #define permutations, and the way back from a compiler's message to the
// line that a person wrote. Needs no GL.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "framework/base/error.h"

namespace relief {

struct ShaderSource {
    std::filesystem::path stage;
    std::string text;             ///< what the compiler gets
    std::vector<Place> lines;     ///< where each line of the text comes from; a #define that was put in has no file
    std::set<std::string> names;  ///< every u_ and s_ name in the files, whether or not it is in use
};

/// Reads a stage and what it includes. `#include "common/light.glsl"` is looked for beside the including file, then
/// below the course's `shaders` folder; a file is taken once. `defines` ("NAME" or "NAME VALUE") follow the `#version`
/// line, which the stage's first line must be. Throws Error with file and line.
ShaderSource load_shader(const std::filesystem::path& stage, const std::vector<std::string>& defines);

/// What a text includes itself, as it names it; a line that is none is passed over.
std::set<std::string> included_by(const std::string& text);

/// A compiler's log with each "0:12(5): " or "0(12) : " replaced by the file and the line that line 12 of the text
/// comes from, and the first error in it. (#line with a number for each file would be the language's own way, but
/// Mesa 22.3 forgets the file's number in some messages: "undeclared" is one.) With `source`, what was compiled, the
/// line that is meant follows each message, once, and where the compiler says a column, a mark below it.
struct ShaderLog {
    Place first;
    std::string first_message;
    std::string text;
};
ShaderLog explain_log(const std::string& log, const std::vector<Place>& lines, const std::string& source = {});

}  // namespace relief
