// Builds a lab with another task.cpp from the objects of this build, and runs its checks.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "framework/core/image/image.h"
#include "framework/core/lab/registry.h"
#include "framework/staff/grade/overlay.h"

namespace relief {

struct VariantCheck {
    std::string task, name, outcome, found;
    std::string mistake;  ///< hint of the mistake that is named for the task
    std::string look_at;
};

/// The lab's program, or the one that finds faults of C++ tasks and runs them for `relief check`.
enum class VariantProgram { plain, finds_faults };

/// The pictures that the checks of a lab compare with, by check name.
using Expectations = std::map<std::string, std::optional<Image>>;

/// Runs all checks with the lab's own executable, built with `files` in place of the course's files. Compiles the
/// sources in `files`. Fails the test if they do not compile.
std::vector<VariantCheck> check_variant(const LabEntry& lab, const grade::CourseFiles& files,
                                        const Expectations& expected, VariantProgram kind = VariantProgram::plain);

}  // namespace relief
