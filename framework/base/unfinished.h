// What a starter has in place of a task that is not written yet.
//
// It includes nothing: students' files include it, and <string> alone would double the time that a short one compiles.
#pragma once

namespace relief {

/// Called by a student's function that is not written yet: throws Error that names the task, and the file and line of
/// the call (std::source_location is not in every clang still in use). For shaders, common/unfinished.glsl has the
/// equivalent.
[[noreturn]] void unfinished(const char* task, const char* file = __builtin_FILE(), int line = __builtin_LINE());

}  // namespace relief
