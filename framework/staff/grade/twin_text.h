// The staff's copy of a shader task file, rewritten to double precision: the twins of its functions. Needs no GL.
#pragma once

#include <filesystem>
#include <string>

#include "framework/course/explain/watched_shader.h"
#include "framework/course/manifest/manifest.h"

namespace relief::grade {

/// Returns the twin of a task file. `text` is the file with its solutions; `includes` is the text of its included
/// files, except unfinished.glsl.
check::TwinText twin_text(const std::string& text, const std::string& includes);

/// Returns the twins of every shader task file of the lab, from the course's current files.
check::Twins twins_of_course(const Manifest& manifest);

}  // namespace relief::grade
