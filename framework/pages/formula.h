// Formulas of a handout as MathML: no scripts, prints, fits a phone.
#pragma once

#include <string>

#include "framework/base/formula.h"

namespace relief {

/// One formula as a <math> element.
std::string formula_mathml(const Formula& formula);

}  // namespace relief
