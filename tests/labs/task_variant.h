// A lab with another task.cpp: compiled and linked with what the build already has, then asked for its checks.
#pragma once

#include <string>
#include <vector>

#include "framework/grade/overlay.h"
#include "framework/lab/registry.h"

namespace relief {

struct VariantCheck {
    std::string name, outcome, found;
};

/// The checks of one task by the lab's own executable, with `files` in place of the course's. Fails the test when that
/// does not compile.
std::vector<VariantCheck> check_with_task(const LabEntry& lab, const std::string& task, const CourseFiles& files);

}  // namespace relief
