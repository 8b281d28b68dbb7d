// Values of calls of a task's functions, drawn as a picture: for what a task's text asks for, and no view of the lab
// shows.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "framework/core/base/from_staff.h"
#include "framework/core/lab/shot.h"

namespace relief::check {

/// Returns the value of a call of a C++ task. Empty if the program has no such call. Only programs that the grader
/// makes have calls.
inline FromStaff<std::optional<glm::dvec4>(const std::string& call)> value_of_call;

/// Returns a value of a C++ task's function as one pixel. Missing components are 0.
template <glm::length_t count, class Number>
glm::dvec4 as_pixel(const glm::vec<count, Number>& value) {
    glm::dvec4 pixel(0);
    for (glm::length_t i = 0; i < count; ++i) pixel[i] = double(value[i]);
    return pixel;
}
inline glm::dvec4 as_pixel(double value) { return {value, 0, 0, 0}; }

/// Returns what draws a shot: the lab, or the values of the shot's calls, from left to right in one row.
std::unique_ptr<Lab> make_drawer(const LabEntry& lab, const Shot& shot);

}  // namespace relief::check
