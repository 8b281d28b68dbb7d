// Compares code regardless of its names, to find a solution that was copied and renamed.
#pragma once

#include <string>
#include <vector>

namespace relief {

/// Returns code in a form that does not depend on its names. Words that are neither called nor members become '@'.
/// Comments, blanks, namespaces and the suffixes of numbers are dropped.
std::string shape_of(const std::string& text);

/// Returns the shapes of the returned or assigned expressions of a solution that have at least 14 words.
std::vector<std::string> expressions_of(const std::vector<std::string>& solution);

/// Returns the text between fences, concatenated.
std::string code_in_markdown(const std::string& text);

/// Returns whether a shape is arithmetic that any code may need: the position of a value between two others.
bool is_common(const std::string& shape);

}  // namespace relief
