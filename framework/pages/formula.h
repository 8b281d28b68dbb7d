// Formulas of a handout, written as plain text, as MathML: no scripts, prints, fits a phone.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace relief {

/// A part of a formula's line.
struct FormulaCell {
    bool is_words = false;  ///< `text` is plain; else it is a <math> element
    std::string text;
};

/// The lines of a block ```formula. Two or more spaces part the cells of a line; a cell in double quotes is words.
///
///     "steep"  t = i / N  "the first layer that is not above the surface"
///
/// Within a formula: names and numbers; `f0`, `w_i`, `h_u` have subscripts, `x^2`, `M^-T`, `n'` stand high, `p.xy` and
/// `to_light` are one name; names beside each other are a product; `a / b` is a fraction of what stands directly
/// beside it, `(a b) / (c d)` of the groups without their brackets; `sqrt(x)`, `|x|`, `sum`, `grad`, `<=`, `>=`,
/// `<=>`, `->` and Greek letters by their names are signs; "text" is words. Throws Error for brackets that do not match
/// and for characters that are none of these.
std::vector<std::vector<FormulaCell>> formula_lines(std::string_view block);

/// One formula as a <math> element.
std::string formula_mathml(std::string_view formula);

}  // namespace relief
