// The record at the top of a submission's page: points, adjustments by people and rules, and missing labs.
#pragma once

#include <string>

#include "framework/staff/class/record.h"
#include "framework/staff/pages/student_page.h"

namespace relief::pages {

/// Returns the page with its record replaced. The rest of a page cannot be regenerated, since its pictures are stored
/// nowhere else. A page without a record is returned unchanged.
std::string with_record(const std::string& page, const grade::StudentRecord& record, grade::UtcOffset offset,
                        PageFor reader);

}  // namespace relief::pages
