// What grading leaves in its folder besides a result for each submission.
#pragma once

#include <filesystem>

#include "framework/staff/grade/class.h"

namespace relief {

/// The page of a submission, relative to the folder of all results.
std::filesystem::path student_page_file(const std::string& name);

/// results.csv, junit.xml, report.html and gradescope/NAME.json, from what the results hold alone. A submission that
/// has no page yet gets one without pictures.
void write_summaries(const ClassReport& report, const std::filesystem::path& folder);

}  // namespace relief
