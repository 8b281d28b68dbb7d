// Why a probe has no exact values, for messages.
#pragma once

#include <string>

#include "framework/core/lab/registry.h"
#include "framework/core/lab/shot.h"

namespace relief {

/// Returns why a shot's probe has no exact values, or why no probe has any if the shot names none. Names the value of a
/// knob that gives them, if one does. In a students' course, the code that computes them is missing. Needs no context.
std::string no_truth(const LabEntry& lab, const Shot& shot);

}  // namespace relief
