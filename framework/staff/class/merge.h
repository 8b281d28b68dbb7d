// Merges a class that was graded in parts (shards) on several machines.
#pragma once

#include <filesystem>
#include <vector>

#include "framework/staff/class/class.h"

namespace relief::grade {

/// Returns the folders that hold a part of a class: `folder` itself, or its subfolders. Throws UsageError if there is
/// none.
std::vector<std::filesystem::path> class_parts(const std::filesystem::path& folder);

/// Reads and merges the results of all parts in `folder`. Throws Error unless every submission of the class has exactly
/// one result, and all results have the same files, course and seed.
ClassReport merge_class(const std::filesystem::path& folder);

}  // namespace relief::grade
