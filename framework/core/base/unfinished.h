// The function that a starter calls in place of a task that is not written yet.
//
// This file includes nothing, because students' files include it: <string> alone would double the compile time of a
// short one.
#pragma once

namespace relief {

/// Throws Error that names the task, and the file and line of the call. A student's function calls it until it is
/// written. (std::source_location is missing in some versions of clang that are still in use.) Its equivalent for
/// shaders is in common/unfinished.glsl.
[[noreturn]] void unfinished(const char* task, const char* file = __builtin_FILE(), int line = __builtin_LINE());

}  // namespace relief
