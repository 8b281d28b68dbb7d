// Source files that arrive in another encoding, with other ends of lines, or with characters of a word processor.
#include "framework/core/base/source_text.h"

#include <gtest/gtest.h>

#include "tests/support.h"

namespace relief {
namespace {

using namespace std::string_literals;

/// Returns "LINE: MESSAGE", or nothing.
std::string fault_in(const std::string& text, const std::string& file = "task.glsl") {
    const auto fault = fault_of_source(plain_source(text), file);
    return fault ? std::to_string(fault->line) + ": " + fault->message : "";
}

/// Returns an ASCII text in units of several bytes. `first` is the place of the byte that is not 0.
std::string widened(const std::string& ascii, size_t size, size_t first) {
    std::string wide;
    for (const char c : ascii) {
        std::string unit(size, '\0');
        unit[first] = c;
        wide += unit;
    }
    return wide;
}

TEST(SourceText, EndsLinesInLfAndHasNoByteOrderMark) {
    EXPECT_EQ(plain_source("\xef\xbb\xbf"
                           "a\r\nb\rc\r\rd\n\re\r"),
              "a\nb\nc\n\nd\n\ne\n");
    EXPECT_EQ(plain_source("a\nb"), "a\nb");
    EXPECT_EQ(plain_source(""), "");
    EXPECT_EQ(fault_in("float a;\rfloat b\xc2\xa0;\r"),
              "2: column 8 is a no-break space (U+00A0): write a blank instead");
}

TEST(SourceText, NamesOtherEncodings) {
    const std::string text = "// a task\nfloat f() { return 1.0; }\n";
    EXPECT_EQ(fault_in("\xff\xfe" + widened(text, 2, 0)), "0: this is text in UTF-16: save it as UTF-8");
    EXPECT_EQ(fault_in("\xfe\xff" + widened(text, 2, 1)), "0: this is text in UTF-16: save it as UTF-8");
    EXPECT_EQ(fault_in(widened(text, 2, 0)), "0: this is text in UTF-16: save it as UTF-8") << "without a mark";
    EXPECT_EQ(fault_in("\xff\xfe\0\0"s + widened(text, 4, 0)), "0: this is text in UTF-32: save it as UTF-8");
    EXPECT_EQ(fault_in(widened(text, 4, 3)), "0: this is text in UTF-32: save it as UTF-8");
    EXPECT_EQ(fault_in("\xff\xfe" + widened(text, 2, 0), "task.cpp"), "0: this is text in UTF-16: save it as UTF-8");
    EXPECT_EQ(fault_in("float a; // \xe9\nfloat \xe9;\n"),
              "2: column 7 is a byte 0xe9, which is not UTF-8: save the file as UTF-8")
        << "Latin-1, which is harmless in a comment";
}

TEST(SourceText, NamesTheFirstByteZeroEvenInAComment) {
    EXPECT_EQ(fault_in("float a;\n// a \0 b\n"s), "2: column 6 is a byte 0, where a compiler stops reading: remove it");
    EXPECT_EQ(fault_in("int a;\n\0"s, "task.cpp"),
              "2: column 1 is a byte 0, where a compiler stops reading: remove it");
}

TEST(SourceText, NamesCharactersOfAWordProcessorWithTheirColumn) {
    EXPECT_EQ(fault_in("// \xe2\x80\x9cwords\xe2\x80\x9d /* \xc2\xa0 */\nfloat /* \xc3\xa4 */ a = b \xe2\x80\x93 c;\n"),
              "2: column 21 is a dash (U+2013): write - instead");
    EXPECT_EQ(fault_in("float a;\n\tfloat b\xef\xbc\x9b\n"),
              "2: column 9 is a wide semicolon (U+FF1B): write ; instead");
    EXPECT_EQ(fault_in("float \xcf\x80 = 3.14;\n"),
              "1: column 7 is '\xcf\x80' (U+03C0): outside of comments GLSL has only ASCII characters");
    EXPECT_EQ(fault_in("float a; // \\\n\xc3\xa4\n"), "") << "a backslash continues the comment";
    EXPECT_EQ(fault_of_source("\tfloat \xc3\xa4 = \xe2\x88\x92"
                              "1.0;\n",
                              "task.glsl")
                  ->quote,
              "        float \xc3\xa4 = \xe2\x88\x92"
              "1.0;\n              ^\n");
}

TEST(SourceText, OfCppMayHaveLettersAndQuotesOfAllLanguages) {
    EXPECT_EQ(fault_in("double \xcf\x80 = 3.14; // \xc2\xa0\nauto s = \"\xc2\xa0\\\"\xe2\x80\x9c\"; char c = '\"';\n"
                       "int i = 1'000; const char* t = \"/*\";\n",
                       "task.cpp"),
              "");
    EXPECT_EQ(fault_in("int a;\nint\xc2\xa0"
                       "b;\n",
                       "task.cpp"),
              "2: column 4 is a no-break space (U+00A0): write a blank instead");
    EXPECT_EQ(fault_in("#if 1\n", "task.cpp"), "") << "gcc reads a file by itself, and names the line";
}

TEST(SourceText, OfGlslClosesWhatItOpens) {
    EXPECT_EQ(fault_in("float a;\n/* never\nclosed /*\n"), "2: this comment is never closed by */");
    EXPECT_EQ(fault_in("float a;\n#if 0\n#ifdef A\n#endif\nfloat b;\n"), "2: this #if has no #endif in this file");
    EXPECT_EQ(fault_in("float a;\n  # endif\n"), "2: this #endif has no #if before it in this file");
    EXPECT_EQ(fault_in("#else\n"), "1: this #else has no #if before it in this file");
    EXPECT_EQ(fault_in("/* a */ // */ /*\n// #if\n/* #if */\n#ifndef A\n#elif B\n#endif\nfloat a = b / *c;\n"), "");
}

TEST(SourceText, OfGlslDoesNotEndInABackslash) {
    const std::string message =
        "the last line ends in a backslash, which joins it with the line behind it: remove the backslash";
    EXPECT_EQ(fault_in("float a;\nfloat b; // \\"), "2: " + message);
    EXPECT_EQ(fault_in("float a;\nfloat b; // \\\n"), "2: " + message);
    EXPECT_EQ(fault_in("#define A \\\n  1.0\nfloat b; // \\\n\n"), "") << "an empty line follows";
}

TEST(SourceText, SurvivesEveryBeginningOfItself) {
    const std::string text =
        "\xef\xbb\xbf/* \xe2\x80\x9c */ #if R\"a(\\\r\n'\"\xc2\xa0\\\n#\n//\\\n\xf0\x9f\x98\x80*/\\";
    for (size_t size = 0; size <= text.size(); ++size)
        for (const char* file : {"task.glsl", "task.cpp"}) fault_in(text.substr(0, size), file);
}

TEST(SourceText, AMarkedLineStandsRightBehindTabsAndOtherLetters) {
    EXPECT_EQ(marked_line("a\tb\t\xc3\xa4 c", 7), "    a   b   \xc3\xa4 c\n              ^\n");
    EXPECT_EQ(marked_line("abc", 3), "    abc\n       ^\n") << "behind the end";
    EXPECT_EQ(marked_line("abc", std::string::npos), "    abc\n");
    EXPECT_EQ(marked_line("a\x1b[31m", 0), "    a [31m\n    ^\n") << "no control characters";
}

}  // namespace
}  // namespace relief
