// A lab with another task.cpp: compiled and linked with what the build already has, then asked for its checks.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "framework/image/image.h"
#include "framework/lab/registry.h"
#include "framework/staff/grade/overlay.h"

namespace relief {

struct VariantCheck {
    std::string task, name, outcome, found;
    std::string mistake;  ///< that is named at the task: its hint
};

/// What the checks of a lab compare with, by their names.
using Expectations = std::map<std::string, std::optional<Image>>;

/// All checks by the lab's own executable, with `files` in place of the course's: its sources are compiled. Fails the
/// test when they do not compile.
std::vector<VariantCheck> check_variant(const LabEntry& lab, const CourseFiles& files, const Expectations& expected);

}  // namespace relief
