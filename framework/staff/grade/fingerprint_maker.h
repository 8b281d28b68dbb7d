// Makes the fingerprints with which the students' `relief check` recognises known mistakes.
#pragma once

#include <functional>
#include <string>

#include "framework/course/check/fingerprints.h"
#include "framework/staff/grade/mistake_pictures.h"

namespace relief::grade {

/// Returns a hash of the manifest's inputs to the fingerprints: the known mistakes, and the shots of public checks. The
/// solution's values are in the fingerprints themselves.
std::string fingerprints_made_of(const LabEntry& lab, const Manifest& manifest);

/// Draws the solution and every known mistake that is not `same_as` another. Joins the hints of mistakes that no public
/// check distinguishes. Omits a mistake that draws the same as the solution. Calls `begins` with each mistake's id
/// before it is drawn. Needs a context, pinned as for `relief check`. Throws Error if the solution cannot be drawn.
check::Fingerprints make_fingerprints(const LabEntry& lab, MistakePictures& pictures,
                                      const std::function<void(const std::string& mistake)>& begins);

}  // namespace relief::grade
