// The page of questions for students: which of four known mistakes made this picture?
#pragma once

#include <filesystem>
#include <vector>

#include "framework/core/lab/registry.h"
#include "framework/course/app/command.h"

namespace relief::app {

/// Writes the page and its pictures, a question for each task in a shader that has one. The page has hints and public
/// views, and nothing of the edits. Throws Error if there is no question at all.
void write_quiz(const std::vector<const LabEntry*>& labs, const std::filesystem::path& folder, ContextChoice choice);

}  // namespace relief::app
