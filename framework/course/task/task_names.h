// Names that people and programs give to task files: copies, files without their folders, other letters.
#pragma once

#include <optional>
#include <set>
#include <string>

namespace relief::check {

/// Returns the task file that a name stands for: the one whose path in the course it ends with. Returns nothing for
/// other names, absolute paths and paths with "..". Accepts backslashes, because some Windows programs write them into
/// zips.
std::optional<std::string> task_file_of(const std::string& name, const std::set<std::string>& wanted);

/// Returns whether a name is near that of a task file, so that task_file_meant() may find which one: "task (1).glsl",
/// "Task.glsl", "task.glsl.txt", "lab03.glsl", or "task.glsl" without its folders. False for the names of
/// task_file_of(), for paths that lead outside or into the course's own code (framework), and for task.glsl.new, which
/// a later handout writes beside a student's file.
bool is_near_task_file(const std::string& name, const std::set<std::string>& wanted);

/// Returns the task file that a file of such a name is meant to be. The lab is that of the lines `// TASK 3.1` in its
/// text; else the only one that its path names, as in "lab03" or "03_height_to_normal"; else the only lab with such a
/// file in `wanted`. Nothing if none of these tells.
std::optional<std::string> task_file_meant(const std::string& name, const std::string& text,
                                           const std::set<std::string>& wanted);

/// A name without the mark of a copy at its end, and the copy's number.
struct CopyName {
    std::string original;  ///< "jane" for "jane (2)"
    int number = 0;        ///< 2 for "jane (2)", 1 for "jane - Copy", 0 without a mark
};
/// Reads the marks that browsers, file managers and Canvas write: "(2)", "-2", "- Copy", "copy 2". `name` has no
/// ending such as ".zip".
CopyName copy_name(const std::string& name);

/// Returns the largest number of a copy in a path: 1 for "hand-in (1).zip/shaders/01_a/task.glsl". Later copies have
/// larger numbers.
int copy_number(const std::string& path);

}  // namespace relief::check
