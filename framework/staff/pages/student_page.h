// A submission's page: its tasks and checks, and the pictures of what did not pass.
#pragma once

#include <string>
#include <vector>

#include "framework/staff/grade/results.h"

namespace relief {

/// Who reads a page. A student's can be given away: it says nothing of a hidden view, of a hidden check only how it
/// went and what to look at, and it leads nowhere.
enum class PageFor { instructor, student };

/// Needs nothing else. A check has its figures where `pictures` has it. It stands as the submission alone:
/// with_standing() puts in what the class adds. What strangers wrote is text in it, never markup.
std::string student_page(const SubmissionMark& mark, const std::vector<CheckPictures>& pictures, PageFor reader);

/// The number of a lab, "02", and its title; for a lab that this course does not have, its name in words.
std::string number_of(const std::string& folder);
std::string lab_title(const std::string& folder);
/// "1 file", "2 files"
std::string count_of(size_t count, const std::string& what);

}  // namespace relief
