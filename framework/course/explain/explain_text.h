// The text about one pixel in `relief explain` and in the window.
#pragma once

#include <string>
#include <vector>

#include "framework/course/explain/explain.h"

namespace relief::check {

/// Calls `take` for each value of a call, with its shape and a pointer to its numbers. `take` must advance the pointer
/// by the count of numbers in the shape.
template <class Number, class Take>
void each_value(const std::vector<ValueShape>& shapes, const std::vector<Number>& numbers, Take take) {
    const Number* at = numbers.data();
    for (const ValueShape& shape : shapes) take(shape, at);
}

/// Returns "returns", or the name of an output parameter.
std::string name_of_result(const ValueShape& shape);

struct ExpectedValue {
    std::vector<float> value = {};  ///< empty if the pixel's value is unknown
    std::string from = {};          ///< "the exact value", "expected by the check"
};

struct PixelReport {
    const LabEntry& lab;
    const Manifest& manifest;
    const Shot& shot;
    glm::ivec2 pixel;
    const Explanation& explanation;
    ExpectedValue expected;
    bool has_twins;
};

/// Returns each function with its calls, their values below each other. The line of the first function that differs
/// begins with '>'.
std::string text_of(const PixelReport& report);

/// Returns a line with the first function that differs, if there is one. Empty without twins.
std::string conclusion_of(const PixelReport& report);

}  // namespace relief::check
