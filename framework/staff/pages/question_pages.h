// The pages of questions about students' own code: a sheet for each student, without answers, and the teacher's key.
#pragma once

#include <string>
#include <vector>

#include "framework/staff/questions/questions.h"

namespace relief::pages {

/// One student's questions.
struct StudentQuestions {
    std::string name;  ///< of the submission
    std::vector<grade::Question> questions;
    size_t wanted = 0;                  ///< the number of questions that was asked for
    std::vector<std::string> problems;  ///< why a lab has no questions, a line each
};

/// Returns a page to print on A4, without answers. It needs no other files.
std::string question_sheet(const StudentQuestions& student);

/// Returns the page with all answers, without pictures of students.
std::string question_key(const std::vector<StudentQuestions>& students);

/// Returns all questions with their answers as JSON, for scripts. `seed` is empty if it is kept elsewhere.
std::string questions_json(const std::vector<StudentQuestions>& students, const std::string& seed);

}  // namespace relief::pages
