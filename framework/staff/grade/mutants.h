// Mutants of a solution: each has one small change, of the kind that people make by mistake.
//
// If the checks of a lab do not see a change that can be seen, they let that mistake pass (DeMillo, Lipton and Sayward
// 1978).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace relief {

struct Mutant {
    std::string task;      ///< "11.2": the last one that the file names before the change
    std::string rule;      ///< "sign", "operator", "dropped call", "output"
    int line = 0;          ///< in the file with the solution, from 1 on
    std::string was, now;  ///< what was changed, on one line
    std::string text;      ///< of the whole file
};

/// All mutants by rule of a task file's solutions, in the order of the text; no two are the same. What does not compile
/// is among them: this reads tokens, not the language. `header` declares the structs that its functions return and that
/// it does not declare itself.
std::vector<Mutant> mutants_of(const std::string& text, const std::filesystem::path& file,
                               const std::string& header = {});

}  // namespace relief
