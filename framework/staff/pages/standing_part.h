// The standing at the top of a submission's page: points, adjustments by people and rules, and missing labs.
#pragma once

#include <string>

#include "framework/staff/class/standing.h"
#include "framework/staff/pages/student_page.h"

namespace relief::pages {

/// Returns the page with its standing replaced. The rest of a page cannot be regenerated, since its pictures are stored
/// nowhere else. A page without a standing is returned unchanged.
std::string with_standing(const std::string& page, const grade::Standing& standing, grade::UtcOffset offset,
                          PageFor reader);

}  // namespace relief::pages
