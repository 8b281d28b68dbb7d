// Writes the summaries of a grading run into its folder, beside the result of each submission.
#pragma once

#include <filesystem>

#include "framework/staff/class/class.h"
#include "framework/staff/class/record.h"
#include "framework/staff/pages/student_page.h"

namespace relief::pages {

inline constexpr PageFor page_readers[] = {PageFor::instructor, PageFor::student};

/// Returns the path of a submission's page, relative to the folder of all results. students/NAME.html can be given to
/// the student; submissions/NAME.html shows everything.
std::filesystem::path page_file(const std::string& name, PageFor reader);

/// Writes a page, and makes its folder if necessary.
void write_page(const std::filesystem::path& file, const std::string& text);

/// Writes all other files, from the results, the folder's class file and its adjustments alone. These are report.html,
/// results.csv and junit.xml, and a file per submission in surefire, gradescope and prairielearn. With a roster there
/// are also canvas.csv, and moodle/LAB.csv for each worksheet. Puts the record into all pages; a submission without
/// pages gets them without pictures. `report` must outlive the result.
grade::ClassRecord write_summaries(const grade::ClassReport& report, const std::filesystem::path& folder);

}  // namespace relief::pages
