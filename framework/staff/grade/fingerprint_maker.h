// Makes the fingerprints by which everybody's `relief check` names known mistakes.
#pragma once

#include <functional>
#include <string>

#include "framework/check/fingerprints.h"
#include "framework/staff/grade/mistake_pictures.h"

namespace relief {

/// A hash of what fingerprints are made of in the manifest: known mistakes, and the shots of public checks. What the
/// solution draws is in the fingerprints themselves.
std::string fingerprints_made_of(const LabEntry& lab, const Manifest& manifest);

/// Draws the solution and every known mistake, but for those that are `same_as` another. Hints of mistakes that no
/// public check tells apart are joined, and a mistake that draws what the solution draws is left out. `begins` is told
/// each mistake's id before it is drawn. Needs a context, pinned as for `relief check`. Throws Error if the solution
/// cannot be drawn.
Fingerprints make_fingerprints(const LabEntry& lab, MistakePictures& pictures,
                               const std::function<void(const std::string& mistake)>& begins);

}  // namespace relief
