// Programs of other projects that the staff's commands run, such as marp-cli and CMake.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "framework/core/base/process.h"

namespace relief::app {

/// Runs a program in a folder and waits for it to exit, for at most `seconds`. The program gets the few variables of
/// the environment that such programs need.
ProcessResult run_tool(const std::vector<std::string>& command, const std::filesystem::path& folder, double seconds);

}  // namespace relief::app
