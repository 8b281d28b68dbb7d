// Formulas of a handout as MathML, which needs no scripts, prints well, and fits a phone.
#pragma once

#include <string>

#include "framework/course/pages/formula.h"

namespace relief::pages {

/// Returns a formula as a <math> element.
std::string formula_mathml(const Formula& formula);

}  // namespace relief::pages
