// Formulas of handouts as MathML.
#include "framework/course/pages/mathml.h"

#include <gtest/gtest.h>

#include "framework/core/base/error.h"

namespace relief::pages {
namespace {

/// Returns the MathML of a formula without the outer element that all formulas share.
std::string inside(const std::string& formula) {
    static const std::string opening = "<math displaystyle=\"true\"><mrow>", closing = "</mrow></math>";
    const std::string all = formula_mathml(parse_formula(formula));
    EXPECT_TRUE(all.starts_with(opening) && all.ends_with(closing)) << all;
    return all.substr(opening.size(), all.size() - opening.size() - closing.size());
}

TEST(Formula, AFractionTakesTheAdjacentTerms) {
    EXPECT_EQ(inside("a / b"), "<mfrac><mrow><mi>a</mi></mrow><mrow><mi>b</mi></mrow></mfrac>");
    EXPECT_EQ(
        inside("2 x/y"),
        "<mn>2</mn><mspace width=\"0.2em\"></mspace><mfrac><mrow><mi>x</mi></mrow><mrow><mi>y</mi></mrow></mfrac>");
}

TEST(Formula, AFractionDropsGroupBracketsButKeepsThoseOfVectorsAndCalls) {
    EXPECT_EQ(inside("(a + b) / 2"),
              "<mfrac><mrow><mi>a</mi><mo>+</mo><mi>b</mi></mrow><mrow><mn>2</mn></mrow></mfrac>");
    EXPECT_NE(inside("(a, b) / 2").find(">(</mo>"), std::string::npos);
    EXPECT_NE(inside("f(a) / 2").find(">(</mo>"), std::string::npos);
}

TEST(Formula, SubscriptsAndSuperscriptsAreMarked) {
    EXPECT_EQ(inside("w_i"), "<msub><mi>w</mi><mrow><mi>i</mi></mrow></msub>");
    EXPECT_EQ(inside("f0"), "<msub><mi>f</mi><mrow><mn>0</mn></mrow></msub>");
    EXPECT_EQ(inside("M^-T"), "<msup><mi>M</mi><mrow><mo>−</mo><mi>T</mi></mrow></msup>");
    const std::string prime = "<mo lspace=\"0\" rspace=\"0\">′</mo>";
    EXPECT_EQ(inside("n''"), "<mrow><mi>n</mi>" + prime + prime + "</mrow>");
    EXPECT_EQ(inside("p'_u"), "<mrow><msub><mi>p</mi><mrow><mi>u</mi></mrow></msub>" + prime + "</mrow>");
    EXPECT_EQ(inside("x²"), inside("x^2"));
}

TEST(Formula, TwoScriptsOfANameFormOnePair) {
    EXPECT_EQ(inside("f0^2"), "<msubsup><mi>f</mi><mrow><mn>0</mn></mrow><mrow><mn>2</mn></mrow></msubsup>");
}

TEST(Formula, AnArgumentAfterAScriptBelongsToTheWholeName) {
    EXPECT_EQ(inside("h_i(x)"),
              "<mrow><msub><mi>h</mi><mrow><mi>i</mi></mrow></msub><mrow><mo stretchy=\"false\">(</mo><mi>x</mi>"
              "<mo stretchy=\"false\">)</mo></mrow></mrow>");
}

TEST(Formula, AGroupWithSemicolonsIsAMatrix) {
    EXPECT_NE(inside("(a, b; c, d)")
                  .find("<mtable><mtr><mtd><mi>a</mi></mtd><mtd><mi>b</mi></mtd></mtr><mtr><mtd><mi>c</mi></mtd>"),
              std::string::npos);
}

TEST(Formula, NamesOfCodeStayWhole) {
    EXPECT_EQ(inside("to_light.xy"), "<mi>to_light.xy</mi>");
    EXPECT_EQ(inside("slope_x"), "<msub><mi>slope</mi><mrow><mi>x</mi></mrow></msub>");
}

TEST(Formula, SignsAndWordsAreEscapedAndTypeset) {
    EXPECT_EQ(inside("a <= pi"), "<mi>a</mi><mo>≤</mo><mi>π</mi>");
    EXPECT_EQ(inside("a < b"), "<mi>a</mi><mo>&lt;</mo><mi>b</mi>");
    EXPECT_EQ(inside("\"if <b>\""), "<mtext>if &lt;b&gt;</mtext>");
    EXPECT_EQ(inside("sqrt(x)"), "<msqrt><mi>x</mi></msqrt>");
}

TEST(Formula, LinesHaveCellsOfFormulasAndWords) {
    const auto lines = formula_lines("\"here\"  a = b  c = d  \"where a <= b - c\"\n\n  x\n");
    ASSERT_EQ(lines.size(), 2u);
    ASSERT_EQ(lines[0].size(), 4u);
    EXPECT_TRUE(lines[0][0].is_words);
    EXPECT_EQ(lines[0][0].words, "here");
    EXPECT_EQ(lines[0][2].formula, parse_formula("c = d"));
    EXPECT_EQ(lines[0][3].words, "where a ≤ b − c");
    EXPECT_EQ(lines[1][0].formula, parse_formula("x"));
}

TEST(Formula, AnInvalidFormulaIsAnError) {
    for (const char* wrong :
         {"(a", "a)", "[a)", "|a", "a /", "a_", "{a}", "\"a", "$", "a^", "a / sum b", "a / grad b", "a/-sum(b)"})
        EXPECT_THROW(parse_formula(wrong), Error) << wrong;
    EXPECT_THROW(formula_lines("\"a"), Error);
    EXPECT_THROW(parse_formula(std::string(100000, '(')), Error);
}

}  // namespace
}  // namespace relief::pages
