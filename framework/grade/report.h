// The instructor's page: the class in one table, and each student's checks with what was found.
#pragma once

#include <string>

#include "framework/grade/class.h"

namespace relief {

/// One page that needs nothing else and opens from disk. What strangers wrote is text in it, never markup.
std::string to_html(const ClassReport& report);

}  // namespace relief
