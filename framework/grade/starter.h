// Tasks in their files: the marks around a solution, the starter that a handout makes of it, and whether it is written.
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
// Whatever else must not be handed out stands between the same marks, with or without a starter.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace relief {

/// The text without its solutions, with what stands after `//|` in their place. A text without marks stays as it is.
/// Throws Error with file and line where marks do not pair.
std::string starter_of(const std::string& text, const std::filesystem::path& file);

/// The lines between the marks of solutions, without blanks around them.
std::vector<std::string> solution_lines(const std::string& text, const std::filesystem::path& file);

/// Whether the code between `TASK id` and the next TASK (or the whole file, when it does not name the task) still calls
/// unfinished().
bool is_unfinished(const std::string& text, const std::string& task);

}  // namespace relief
