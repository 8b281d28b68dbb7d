// What a lab costs a student, and the ways through the course.
#pragma once

#include <string>
#include <vector>

#include "framework/course/manifest/manifest.h"

namespace relief {

/// A choice of labs, in weeks. Each lab.toml says in which week of a path its lab is done.
struct CoursePath {
    const char *name, *title;
    int weeks;
};
inline constexpr CoursePath course_paths[] = {{"short", "Three weeks", 3}, {"term", "A term of twelve weeks", 12}};

/// Throws UsageError that suggests the nearest name.
const CoursePath& find_path(const std::string& name);

/// The labs of one week. `labs` are indices.
struct CourseWeek {
    std::vector<size_t> labs;
    double hours = 0;
};
/// Returns the weeks of a path. A lab that the path does not have is in none.
std::vector<CourseWeek> weeks_of(const CoursePath& path, const std::vector<const Manifest*>& labs);

/// "15 points", "15 points and 7 optional". Precondition: the lab has tasks.
std::string points_of_lab(const Manifest& manifest);

/// "3 hours", "1 hour"
std::string hours_text(double hours);

/// Returns the sentences near the beginning of a handout: "About 3 hours. Before it: lab 01; rounding. C++ in task 2.5.
/// You may leave out task 2.5." Precondition: `hours` is known.
std::string effort_text(const Manifest& manifest);

}  // namespace relief
