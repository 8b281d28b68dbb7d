// A function of a shader by itself: a fragment shader that calls it with given numbers. Needs no GL.
#pragma once

#include <string>
#include <vector>

#include "framework/course/explain/watched_shader.h"

namespace relief::check {

/// The uniform array with the numbers of the arguments, and its size.
constexpr const char* lone_numbers = "u_relief_numbers";
constexpr size_t lone_size = 64;

/// Returns a fragment shader that writes the function's result to the first channels of its output. It contains the
/// function, the functions that this one calls, and the constants and structs of `fragment`. It has no uniform, input
/// or texture of `fragment`: a function that reads one does not compile here. Returns an empty text for a function that
/// nobody can follow by hand: it has a loop, a derivative, an array, an `out` parameter, more than 16 arguments, more
/// than 4 results, or more than 20 statements. `fragment`: the text of a fragment stage with its includes.
std::string lone_function(const std::string& fragment, const std::string& signature);

/// A value as people read it: rounded, with the rounded numbers. A vector or a matrix is rounded to `digits` digits of
/// its largest number, so that the rounding errors of the others vanish. `text` is empty if a number is not finite, or
/// above 1e6 or below 1e-6.
struct ShownValue {
    std::string text;            ///< "0.031", "(0.58, 0.02, -0.81)"
    std::vector<float> numbers;  ///< the numbers in `text`
    double step = 0;             ///< one unit of the last digit, of the coarsest number
};
/// Advances `at` by the numbers of the shape.
ShownValue shown_value(const ValueShape& shape, const float*& at, int digits);

}  // namespace relief::check
