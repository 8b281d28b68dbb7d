// Code whatever its names are, to find a solution that was copied and renamed.
#pragma once

#include <string>
#include <vector>

namespace relief {

/// What stands in code whatever its names are: words that are neither called nor members become '@'; comments, blanks,
/// namespaces and the suffixes of numbers are gone.
std::string shape_of(const std::string& text);

/// The expressions of a solution that are long enough to say something, as shapes: what is returned or assigned.
std::vector<std::string> expressions_of(const std::vector<std::string>& solution);

/// What stands between fences, one after the other.
std::string code_in_markdown(const std::string& text);

/// Arithmetic that nobody can do without: how far something is between two others.
bool is_common(const std::string& shape);

}  // namespace relief
