// Where a student stands, at the head of a submission's page: points, what people and rules changed, what is missing.
#pragma once

#include <string>

#include "framework/staff/grade/standing.h"
#include "framework/staff/pages/student_page.h"

namespace relief {

/// The page with this standing in place of the one that it has. A page keeps pictures that are not stored elsewhere, so
/// this alone of it can be made anew. A page without such a part stays as it is.
std::string with_standing(const std::string& page, const Standing& standing, UtcOffset offset, PageFor reader);

}  // namespace relief
