// The instructor's page: the class in one table, then results by check, and times.
#pragma once

#include <string>

#include "framework/staff/class/class.h"
#include "framework/staff/class/record.h"

namespace relief::pages {

/// Returns a page that needs no other files and has no pictures, about 600 bytes per submission. It links to
/// students/NAME.html. Counts come from `record`; `report` gives the numbers of the run. Students' text is escaped,
/// never markup.
std::string class_page(const grade::ClassReport& report, const grade::ClassRecord& record);
/// The same without a class file.
std::string class_page(const grade::ClassReport& report);

}  // namespace relief::pages
