// Parses formulas in plain text, as in handouts, to trees. The caller decides how to display them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace relief::pages {

/// A formula or a part of one. Every tree can be displayed: no part is empty, except for a row.
struct Formula {
    enum class Kind {
        row,       ///< parts: side by side
        name,      ///< of one or more letters
        number,    //
        sign,      ///< an operator or a relation
        words,     //
        gap,       ///< between the factors of a product
        fraction,  ///< parts: the rows above and below the line
        root,      ///< part: the row below the sign
        scripts,   ///< parts: the base, the subscript row and the superscript row; one of the two may be empty
        bracket,   ///< text: ( or [ or |; part: the row inside
        matrix,    ///< parts: rows, whose parts are the cells
    };
    Kind kind = Kind::row;
    std::string text = {};  ///< the displayed text of names, numbers, signs, words and brackets; UTF-8
    std::vector<Formula> parts = {};
    bool operator==(const Formula&) const = default;
};

/// Returns the closing character for an opening bracket.
constexpr std::string_view closing_of(std::string_view bracket) {
    return bracket == "(" ? ")" : bracket == "[" ? "]" : bracket;
}

/// Parses a formula:
/// - `f0`, `w_i` and `h_u` have subscripts; `x^2`, `M^-T` and `n'` have superscripts.
/// - `p.xy` and `to_light` are one name. Adjacent names are a product.
/// - `a / b` is a fraction of the two adjacent factors; `(a b) / (c d)` is one of the groups without their brackets. A
///   sum or a gradient below the line needs them.
/// - `(a, b; c, d)` is a matrix.
/// - `sqrt(x)`, `|x|`, `sum`, `grad`, `<=`, `>=`, `<=>`, `->` and the names of Greek letters become signs.
/// - "text" is words.
/// Throws Error for brackets that do not match or are nested 30 deep, and for any other character.
Formula parse_formula(std::string_view text);

/// A part of a line of a block: either words, which are plain text, or a formula.
struct FormulaCell {
    bool is_words = false;
    std::string words = {};
    Formula formula = {};
};

/// Parses the lines of a block ```formula. Two or more spaces separate the cells of a line. A cell in double quotes is
/// words.
///
///     "steep"  t = i / N  "the first layer that is not above the surface"
std::vector<std::vector<FormulaCell>> formula_lines(std::string_view block);

}  // namespace relief::pages
