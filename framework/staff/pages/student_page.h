// A submission's page: its tasks and checks, with pictures of failed checks.
#pragma once

#include <string>
#include <vector>

#include "framework/staff/grade/results.h"

namespace relief::pages {

/// The reader of a page. The student's page is safe to give away. It omits hidden views, tells only the outcome and the
/// hint of a hidden check, and has no links to other pages.
enum class PageFor { instructor, student };

/// Returns a page that needs no other files. A check has figures if `pictures` contains it. The page shows the
/// submission alone; with_record() adds the data of the class. Students' text is escaped, never markup.
std::string student_page(const grade::SubmissionMark& mark, const std::vector<grade::CheckPictures>& pictures,
                         PageFor reader);

/// Return the number of a lab, "02", and its title. The title of a lab that this course lacks is its folder's name in
/// words.
std::string number_of(const std::string& folder);
std::string lab_title(const std::string& folder);
/// "1 file", "2 files"
std::string count_of(size_t count, const std::string& what);

}  // namespace relief::pages
