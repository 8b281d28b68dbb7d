// A lab's checks as one web page: results, limits with their reasons, and the compared pictures.
#pragma once

#include <string>
#include <vector>

#include "framework/course/check/check.h"

namespace relief::pages {

/// Returns the hint for the student. If nothing was drawn, nothing was measured, and the check's own hint would
/// mislead; then the hint is about that.
std::string look_at(const check::Verdict& result);

/// Returns the page with its pictures embedded: it opens from disk, without a network. `driver`: that drew them.
std::string check_page(const LabEntry& lab, const Manifest& manifest, const std::vector<check::TaskVerdict>& tasks,
                       const std::string& driver);

}  // namespace relief::pages
