// Marks in source files. Tasks: the marks around a solution, the starter that a handout makes of it, and whether it
// is written. Regions: what slides quote.
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
// Other lines that must not be handed out are between the same marks, with or without a starter. Lines between
//
//     //(name
//     //)
//
// are a region of that name, which may have whole solutions in it but no other region.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace relief {

/// The text with each solution replaced by the lines after `//|`. A text without marks stays as it is.
/// Throws Error with file and line if marks do not pair.
std::string starter_of(const std::string& text, const std::filesystem::path& file);

/// The lines between the marks of solutions, without blanks around them.
std::vector<std::string> solution_lines(const std::string& text, const std::filesystem::path& file);

/// What slides quote: the lines between `//(name` and `//)`, moved to the left margin, without marks and starters.
struct Region {
    std::string text;
    bool has_solution = false;
};
/// Throws Error with the file where there is no such region, and with the line where marks do not pair.
Region region_of(const std::string& text, const std::filesystem::path& file, const std::string& name);

/// Whether the code between `TASK id` and the next TASK (or the whole file, when it does not name the task) still calls
/// unfinished().
bool is_unfinished(const std::string& text, const std::string& task);

}  // namespace relief
