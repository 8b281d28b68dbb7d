// What grading leaves in its folder besides a result for each submission.
#pragma once

#include <filesystem>

#include "framework/staff/grade/class.h"
#include "framework/staff/grade/standing.h"
#include "framework/staff/pages/student_page.h"

namespace relief {

inline constexpr PageFor page_readers[] = {PageFor::instructor, PageFor::student};

/// The page of a submission, relative to the folder of all results: students/NAME.html can be given to its student,
/// submissions/NAME.html has all that is known.
std::filesystem::path page_file(const std::string& name, PageFor reader);

/// With the folder that it lies in.
void write_page(const std::filesystem::path& file, const std::string& text);

/// All other files, from the results, the folder's class file and its adjustments alone: report.html, results.csv,
/// junit.xml, and a file for each submission in surefire, gradescope and prairielearn; with a roster canvas.csv, and
/// moodle/LAB.csv for each worksheet. Pages get their standing; a submission that has no pages yet gets them without
/// pictures. The report must outlive the result.
ClassStanding write_summaries(const ClassReport& report, const std::filesystem::path& folder);

}  // namespace relief
