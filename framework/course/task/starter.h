// Reads marks in source files: solutions with their starters, and the regions that slides quote.
//
//     float crossing(float before, float after) {
//         // TASK 11.2 (3 points): where do the two lines meet?
//         //[solution
//         return before / (before + after);
//         //]starter
//         //| return unfinished(0.0);
//         //]
//     }
//
// The same marks, with or without a starter, also enclose other lines that must not be handed out. Lines between
//
//     //(name
//     //)
//
// are a region of that name. A region can contain whole solutions, but no other region.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace relief::check {

/// Returns the text with each solution replaced by its starter, the lines after `//|`. Returns a text without marks
/// unchanged. Throws Error with file and line if the marks do not match.
std::string starter_of(const std::string& text, const std::filesystem::path& file);

/// Returns the text with its solutions, without marks and starters. Throws Error as starter_of() does.
std::string solution_of(const std::string& text, const std::filesystem::path& file);

/// Returns the lines of all solutions, trimmed, without empty lines.
std::vector<std::string> solution_lines(const std::string& text, const std::filesystem::path& file);

/// The lines between `//(name` and `//)`, without common indentation, marks and starters.
struct Region {
    std::string text;
    bool has_solution = false;
};
/// Throws Error with the file if there is no such region, and with file and line if the marks do not match.
Region region_of(const std::string& text, const std::filesystem::path& file, const std::string& name);

/// One task's part of a task file of the staff's, which has these comments: from its first line "// TASK 11.2" to the
/// first such line of another task.
struct TaskPart {
    std::string task;  ///< the task's id; empty for the part before the first task
    std::string text;
};
/// Returns the parts of a task file in order. The first part is the text before the first task, which may be empty.
std::vector<TaskPart> task_parts(const std::string& text);

}  // namespace relief::check
