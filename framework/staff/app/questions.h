// Questions about students' own code, for `relief questions` and `relief grade --questions`.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "framework/staff/class/class_file.h"
#include "framework/staff/grade/check_views.h"

namespace relief::app {

struct QuestionOptions {
    std::vector<std::filesystem::path> submissions;
    grade::ClassFile policy = {};       ///< has the roster, to which the submissions are assigned
    std::vector<const LabEntry*> labs;  ///< empty: for each submission the labs whose files it has
    std::filesystem::path folder;       ///< gets sheets/NAME.html, key.html and questions.json
    int count = 0;                      ///< questions for each submission
    int jobs = 1;
    std::string seed;
    bool keeps_seed = false;  ///< whether questions.json holds the seed
    grade::GradeSetup setup;  ///< with the isolation of this machine
};

/// Writes the sheets, the key and questions.json, and prints a line for each submission. A submission without questions
/// gets no sheet. Returns the exit code: 1 if there is no sheet at all.
int write_questions(const QuestionOptions& options);

constexpr int most_questions = 20;

}  // namespace relief::app
