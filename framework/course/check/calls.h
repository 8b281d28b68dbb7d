// Values of calls of a task's functions, drawn as a picture: for what a task's text asks for, and no view of the lab
// shows.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "framework/core/lab/shot.h"

namespace relief::check {

/// Returns the value of a call of a C++ task. Empty if the program has no such call: a lab has its public calls (see
/// framework/cmake/calls.cmake), and the programs that the grader makes have the hidden ones, too.
std::optional<glm::dvec4> value_of_call(const std::string& call);

/// Adds calls to the program's list. Define it as a static object.
struct ProvidedCalls {
    using Value = std::optional<glm::dvec4>(const std::string& call);
    explicit ProvidedCalls(Value* value);
};

/// Returns a value of a C++ task's function as one pixel. Missing components are 0.
template <glm::length_t count, class Number>
glm::dvec4 as_pixel(const glm::vec<count, Number>& value) {
    glm::dvec4 pixel(0);
    for (glm::length_t i = 0; i < count; ++i) pixel[i] = double(value[i]);
    return pixel;
}
inline glm::dvec4 as_pixel(double value) { return {value, 0, 0, 0}; }

/// Returns the object that draws a shot: the lab, or the values of the shot's calls, from left to right in one row.
std::unique_ptr<Lab> make_drawer(const LabEntry& lab, const Shot& shot);

}  // namespace relief::check
