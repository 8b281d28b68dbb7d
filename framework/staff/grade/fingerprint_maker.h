// Makes the fingerprints by which the grader and the students' `relief check` recognise known mistakes.
#pragma once

#include <string>
#include <vector>

#include "framework/course/check/fingerprints.h"
#include "framework/staff/grade/attempt.h"

namespace relief::grade {

/// Returns the hint of a known mistake, joined with the hints of mistakes that are `same_as` it.
std::string hint_with_same(const Manifest& manifest, const MistakeInfo& mistake);

/// Returns the mistakes of a task that have fingerprints of their own.
std::vector<const MistakeInfo*> distinct_mistakes(const Manifest& manifest, const std::string& task);
/// Returns the indices of a task's checks that have fingerprints: a few values of calls are no picture.
std::vector<size_t> checks_with_fingerprints(const Manifest& manifest, const std::string& task);

/// The whole pictures that a program draws in some checks, in the order of the checks.
using DrawnProgram = std::vector<check::Sample>;
/// Returns all values of a picture, or the error that replaced it.
check::Sample whole_sample(const DrawnAttempt& drawn);

/// Adds the fingerprints of a task. `mistakes`: what distinct_mistakes() draw in `checks`. The hints of mistakes that
/// draw the same are joined by "Or:". A mistake that draws the same as the solution has no fingerprints.
void add_fingerprints(check::Fingerprints& result, const Manifest& manifest, const std::string& task,
                      const std::vector<size_t>& checks, const DrawnProgram& solution,
                      std::vector<DrawnProgram> mistakes);

/// Returns the text of the fingerprints of a lab's public checks, see check::text_of(). Draws all mistakes in the
/// current context, which must be Mesa's software renderer, and keeps the text in the build folder until a file changes
/// that takes part in the pictures. `begins`: is called before each mistake.
std::string public_fingerprints(const LabEntry& lab, const std::function<void(const std::string& mistake)>& begins);

}  // namespace relief::grade
