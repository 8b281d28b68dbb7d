// What grading leaves in its folder besides a result for each submission.
#pragma once

#include <filesystem>

#include "framework/app/student_page.h"
#include "framework/grade/class.h"

namespace relief {

/// The page of a submission, relative to the folder of all results: students/NAME.html can be given to its student,
/// submissions/NAME.html has all that is known.
std::filesystem::path page_file(const std::string& name, PageFor reader);

/// results.csv, junit.xml, report.html and gradescope/NAME.json, from what the results hold alone. A submission that
/// has no pages yet gets them without pictures.
void write_summaries(const ClassReport& report, const std::filesystem::path& folder);

}  // namespace relief
