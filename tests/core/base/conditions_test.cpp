// The evaluation of a shader's #if lines.
#include "framework/core/base/conditions.h"

#include <gtest/gtest.h>

namespace relief {
namespace {

/// Returns the lines of a text that its #if lines do not leave out, without preprocessor lines, and each with a space
/// after it. "?" if the lines have no balance.
std::string kept(const std::string& text, const std::vector<std::string>& definitions = {}) {
    std::vector<Directive> lines;
    std::string code = text;
    for (const CodeToken& token : all_tokens(text))
        if (token.kind == CodeToken::directive) {
            lines.push_back({token.begin, token.end, tokens_of_directive(token)});
            std::fill_n(code.begin() + long(token.begin), token.end - token.begin, ' ');
        }
    Macros macros;
    for (const std::string& definition : definitions)
        for (const CodeToken& token : all_tokens("#define " + definition)) define(macros, tokens_of_directive(token));
    const auto ranges = left_out(lines, macros);
    if (!ranges) return "?";
    for (const auto& [begin, end] : *ranges) std::fill_n(code.begin() + long(begin), end - begin, ' ');
    std::string result;
    for (const CodeToken& token : code_tokens(code)) result += token.text + " ";
    return result;
}

/// Returns "1" or "0" for an expression that is true or false, "unknown" for another.
std::string value_of(const std::string& expression, const std::vector<std::string>& definitions = {}) {
    const std::string lines = kept("#if " + expression + "\nyes\n#else\nno\n#endif\n", definitions);
    return lines == "yes " ? "1" : lines == "no " ? "0" : lines == "yes no " ? "unknown" : lines;
}

TEST(Conditions, KeepTheBranchThatAPreprocessorKeeps) {
    const std::string text =
        "a\n#ifdef A\nb\n#ifndef B\nc\n#else\nd\n#endif\n#elif defined(B)\ne\n#elif defined "
        "C\nf\n#else\ng\n#endif\nh\n";
    EXPECT_EQ(kept(text, {"A"}), "a b c h ");
    EXPECT_EQ(kept(text, {"A", "B"}), "a b d h ");
    EXPECT_EQ(kept(text, {"B", "C"}), "a e h ");
    EXPECT_EQ(kept(text, {"C 3"}), "a f h ");
    EXPECT_EQ(kept(text), "a g h ");
}

TEST(Conditions, ApplyDefinitionsOnlyInBranchesThatAreKept) {
    EXPECT_EQ(kept("#ifdef A\n#define B\n#else\n#define C\n#endif\n#ifdef B\nb\n#endif\n#ifdef C\nc\n#endif\n"), "c ");
    EXPECT_EQ(kept("#define A\n#undef A\n#ifdef A\na\n#endif\n"), "");
}

TEST(Conditions, EvaluateExpressionsByTheirPrecedence) {
    const std::vector<std::string> definitions = {"TWO 2", "FOUR (TWO + TWO)", "BOTH (TWO == 2 || TWO == 5)", "EMPTY"};
    for (const char* expression :
         {"1", "-1", "TWO == 2", "FOUR - 1 == 3", "8 - 4 - 4 == 0", "(6 & 3) == 2", "7 & 3 == 3", "(4 | 1) == 5",
          "!(1 > 2) && TWO <= 2", "0 && 0 || 1", "1 || 0 && 0", "defined TWO && !defined (THREE)", "BOTH",
          "FOUR >= 4 && FOUR != 5 && 3 < FOUR", "defined EMPTY", "defined NONE && NONE == 3 || TWO == 2"})
        EXPECT_EQ(value_of(expression, definitions), "1") << expression;
    for (const char* expression : {"0", "TWO == 3", "!TWO", "2 - 2", "4 & 3", "6 & 3 == 3", "1 - 1 - 1 + 1",
                                   "defined NONE && NONE == 3", "1 == 2 == 2"})
        EXPECT_EQ(value_of(expression, definitions), "0") << expression;
}

TEST(Conditions, KeepBothBranchesOfWhatTheyDoNotKnow) {
    const std::string brackets(100000, '(');
    for (const std::string& expression :
         {std::string("NONE == 3"), std::string("GL_EXT == 1"), std::string("defined GL_ARB_conservative_depth"),
          std::string("__VERSION__ > 400"), std::string("1 << 2"), std::string("7 % 2"), std::string("PAIR(1)"),
          std::string("SELF"), std::string("1 +"), std::string("defined"), std::string("defined ("), std::string("(1"),
          std::string("0x10"), std::string("010 == 10"), std::string("1 1"), std::string("EMPTY"), std::string(""),
          brackets, "LONG" + std::string(1000, '+')})
        EXPECT_EQ(value_of(expression, {"PAIR(x) x", "SELF SELF", "EMPTY", "LONG 1"}), "unknown")
            << expression.substr(0, 40);
    EXPECT_EQ(value_of("LOTS", {"A 1 + 1 + 1 + 1", "B A + A + A + A", "C B + B + B + B", "LOTS C + C + C + C"}),
              "unknown");
    EXPECT_EQ(kept("#ifdef GL_X\n#define A\n#endif\n#ifdef A\na\n#else\nb\n#endif\n"), "a b ");
    EXPECT_EQ(kept("#if NONE\na\n#elif 0\nb\n#elif 1\nc\n#else\nd\n#endif\n"), "a c d ");
}

TEST(Conditions, RefuseLinesWithoutBalance) {
    for (const char* text : {"#endif\n", "#else\n", "#elif 1\n", "#if 1\n", "#if 0\n", "#if 1\n#endif\n#endif\n",
                             "#if 0\n#if 1\n#endif\n"})
        EXPECT_EQ(kept(text), "?") << text;
    EXPECT_EQ(kept("#\na\n#if 1\n#\nb\n#endif\n"), "a b ");
}

}  // namespace
}  // namespace relief
