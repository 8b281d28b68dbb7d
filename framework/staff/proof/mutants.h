// Makes mutants of a solution: each has one small change, of the kind that people make by mistake.
//
// A lab's checks that do not detect a visible mutant would not detect that mistake either (DeMillo, Lipton and Sayward
// 1978).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace relief::grade {

struct Mutant {
    std::string task;      ///< "11.2": the last task that the file names before the change
    std::string rule;      ///< "sign", "operator", "dropped call", "output"
    int line = 0;          ///< in the file with the solution, counted from 1
    std::string was, now;  ///< the changed piece of code before and after, on one line
    std::string text;      ///< text of the whole changed file
};

/// Returns all mutants of a task file's solutions, in the order of the text, without duplicates. Some do not compile,
/// because the rules work on tokens, not on the language. `header`: declares the structs that the file's functions
/// return and that the file itself does not declare.
std::vector<Mutant> mutants_of(const std::string& text, const std::filesystem::path& file,
                               const std::string& header = {});

/// Returns the mutants of a student's shader, which has no marks: of the body of each function. Each changes one line.
/// None replaces a function's result.
std::vector<Mutant> line_mutants_of(const std::string& shader);

}  // namespace relief::grade
