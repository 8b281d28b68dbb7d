// A task file, cut into tasks by the functions that each task asks for. Comments, the order of the functions and the
// code between them make no difference. Everything else in the file belongs to the tasks that use it.
#pragma once

#include <string>
#include <vector>

#include "framework/course/manifest/manifest.h"
#include "framework/course/task/code_definitions.h"

namespace relief::check {

class TaskText {
public:
    /// `file`: the name of the task file; tasks of other files do not count.
    TaskText(const std::string& text, const std::vector<TaskInfo>& tasks, const std::string& file);

    const std::vector<CodeDefinition>& definitions() const { return definitions_; }
    /// Returns the task whose function the definition is; empty for all other code.
    const std::string& task_of_function(size_t definition) const { return functions_[definition]; }
    /// Returns that task, or for other code the first task that uses it, directly or not. Empty if none does.
    const std::string& owner(size_t definition) const { return owners_[definition]; }
    /// Returns for each definition whether the task's functions use it, directly or not. Does not go through the
    /// functions of other tasks.
    std::vector<bool> used_by_task(const std::string& task) const;

private:
    std::vector<CodeDefinition> definitions_;
    std::vector<std::string> functions_, owners_;
};

/// Returns the functions of a task that a text does not define, as in lab.toml: "crossing(float, float)".
std::vector<std::string> missing_functions(const std::string& text, const TaskInfo& task);
/// Returns "surface.glsl has no function `crossing(float, float)`, which task 11.2 asks for: keep the names and
/// signatures". Empty if none is missing.
std::string missing_text(const std::string& text, const TaskInfo& task);

/// Returns whether a function of the task still calls unfinished(), where no `return` of something else stands before
/// the call: then the function has code of its own, and is judged by that. Comments and code behind `#if 0` do not
/// count. Searches the whole text for a task that names no functions.
bool is_unfinished(const std::string& text, const TaskInfo& task);

/// Returns the line of the first call of unfinished() in the task's functions, behind a `return` or not; 0 if there is
/// none.
int line_of_unfinished(const std::string& text, const TaskInfo& task);

/// Returns the task to which this line of a task file belongs, counted from 1. A line between two definitions belongs
/// to the next one. Empty for a line of no task.
std::string task_at_line(const std::string& text, const std::vector<TaskInfo>& tasks, const std::string& file,
                         size_t line);

/// Returns the line of a task's first function, counted from 1; 0 if there is none.
int line_of_task(const std::string& text, const TaskInfo& task);

}  // namespace relief::check
