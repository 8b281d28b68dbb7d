// Formulas of a handout, written as plain text, as trees. How they are shown is up to the caller.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace relief {

/// A formula or a part of one. What a tree contains can be shown: no part is empty but a row.
struct Formula {
    enum class Kind {
        row,       ///< parts beside each other
        name,      ///< of one letter or of several
        number,    //
        sign,      ///< of an operator or a relation
        words,     //
        gap,       ///< between the factors of a product
        fraction,  ///< parts: the rows above and below the line
        root,      ///< part: the row below the sign
        scripts,   ///< parts: the base, the rows that stand low and high; one of them may be empty
        bracket,   ///< text: ( or [ or |; part: the row inside
        matrix,    ///< parts: rows, whose parts are the cells
    };
    Kind kind = Kind::row;
    std::string text = {};  ///< of names, numbers, signs, words and brackets, as it is shown, UTF-8
    std::vector<Formula> parts = {};
    bool operator==(const Formula&) const = default;
};

/// What closes the bracket of a formula.
constexpr std::string_view closing_of(std::string_view bracket) {
    return bracket == "(" ? ")" : bracket == "[" ? "]" : bracket;
}

/// Names and numbers; `f0`, `w_i`, `h_u` have subscripts, `x^2`, `M^-T`, `n'` stand high, `p.xy` and `to_light` are one
/// name; names beside each other are a product; `a / b` is a fraction of what stands directly beside it,
/// `(a b) / (c d)` of the groups without their brackets; `(a, b; c, d)` is a matrix; `sqrt(x)`, `|x|`, `sum`, `grad`,
/// `<=`, `>=`, `<=>`, `->` and Greek letters by their names are signs; "text" is words. Throws Error for brackets that
/// do not match or stand 30 deep, and for characters that are none of these.
Formula parse_formula(std::string_view text);

/// A part of a line of a block: words, which are plain text, or a formula.
struct FormulaCell {
    bool is_words = false;
    std::string words = {};
    Formula formula = {};
};

/// The lines of a block ```formula. Two or more spaces part the cells of a line; a cell in double quotes is words.
///
///     "steep"  t = i / N  "the first layer that is not above the surface"
std::vector<std::vector<FormulaCell>> formula_lines(std::string_view block);

}  // namespace relief
