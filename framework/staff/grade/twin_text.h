// The staff's copy of a shader task file, rewritten to double precision: the twins of its functions. Needs no GL.
#pragma once

#include <filesystem>
#include <string>

#include "framework/check/watched_shader.h"
#include "framework/lab/manifest.h"

namespace relief {

/// `text` is a task file with its solutions; `includes` the text of what it includes, but for unfinished.glsl.
TwinText twin_text(const std::string& text, const std::string& includes);

/// Of every shader task file of the lab, as this course has it now.
Twins twins_of_course(const Manifest& manifest);

}  // namespace relief
