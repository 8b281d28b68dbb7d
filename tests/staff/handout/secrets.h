// What students must not be able to read.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace relief::handout {

/// Returns the lines of a text without their indents, and without the empty ones.
std::vector<std::string> trimmed_lines(const std::string& text);

/// Expects that no text contains a line of a solution or of a correct variant, a known mistake's hint, or the name of a
/// hidden check. `texts` are files by their paths; `labs` are names of folders in `labs`.
void expect_no_secrets(const std::map<std::string, std::string>& texts, const std::vector<std::string>& labs);

}  // namespace relief::handout
