// Marks in source files: solutions with their starters, and the regions that slides quote.
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
// Other lines that must not be handed out stand between the same marks, with or without a starter. Lines between
//
//     //(name
//     //)
//
// are a region of that name. A region can contain whole solutions, but no other region.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace relief {

/// The text with each solution replaced by its starter, the lines after `//|`. A text without marks stays as it is.
/// Throws Error with file and line if the marks do not match.
std::string starter_of(const std::string& text, const std::filesystem::path& file);

/// The lines of all solutions, trimmed; empty lines are left out.
std::vector<std::string> solution_lines(const std::string& text, const std::filesystem::path& file);

/// The lines between `//(name` and `//)`, moved to the left margin, without marks and starters.
struct Region {
    std::string text;
    bool has_solution = false;
};
/// Throws Error with the file if there is no such region, and with file and line if the marks do not match.
Region region_of(const std::string& text, const std::filesystem::path& file, const std::string& name);

/// Whether the code between `TASK id` and the next TASK still calls unfinished(). If the file does not name the task,
/// the whole file counts.
bool is_unfinished(const std::string& text, const std::string& task);

/// The part of a task file that is about one task: from its first line "// TASK 11.2" to the next such line of another
/// task.
struct TaskPart {
    std::string task;  ///< its id; empty for what stands before the first task
    std::string text;
};
/// The parts of a task file in order: first what stands before the tasks, which may be empty.
std::vector<TaskPart> task_parts(const std::string& text);

/// The task whose part has this line, counted from 1; empty if it is no task's.
std::string task_at_line(const std::string& text, size_t line);

}  // namespace relief
