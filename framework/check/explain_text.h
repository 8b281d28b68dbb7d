// What relief explain and the window say of one pixel.
#pragma once

#include <string>
#include <vector>

#include "framework/check/explain.h"

namespace relief {

/// All values of a call: `take` has a shape, and a pointer that it moves on behind the numbers of that shape.
template <class Number, class Take>
void each_value(const std::vector<ValueShape>& shapes, const std::vector<Number>& numbers, Take take) {
    const Number* at = numbers.data();
    for (const ValueShape& shape : shapes) take(shape, at);
}

/// "returns", or the name of a parameter that is an output.
std::string name_of_result(const ValueShape& shape);

struct ExpectedValue {
    std::vector<float> value = {};  ///< empty where nothing is known of the pixel
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

/// Each function with its calls, their values below each other. A line of the function that is the first to differ
/// begins with '>'.
std::string text_of(const PixelReport& report);

/// What follows: a line with the first function that differs, if one does. Empty without twins.
std::string conclusion_of(const PixelReport& report);

}  // namespace relief
