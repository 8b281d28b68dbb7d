// The instructor's page: the class in one table, check by check, and the time.
#pragma once

#include <string>

#include "framework/staff/grade/class.h"
#include "framework/staff/grade/standing.h"

namespace relief {

/// Needs nothing else and has no pictures, some 600 bytes a submission; links to students/NAME.html. From the marks
/// alone, but for the run's own numbers. What strangers wrote is text in it, never markup.
std::string class_page(const ClassReport& report, const ClassStanding& standing);
/// Without a class file.
std::string class_page(const ClassReport& report);

}  // namespace relief
