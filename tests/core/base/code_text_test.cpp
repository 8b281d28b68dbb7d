// Tokens of code, and functions and structs found in a GLSL text.
#include "framework/core/base/code_text.h"

#include "tests/support.h"

namespace relief {
namespace {

std::vector<std::string> signatures(const std::string& text) {
    std::vector<std::string> found;
    for (const GlslFunction& function : parse_glsl(text).functions)
        found.push_back(function.type + " " + function.signature());
    return found;
}
using Names = std::vector<std::string>;

TEST(GlslText, FindsFunctionsWithTheirParameters) {
    const GlslText text =
        parse_glsl("float f(const in vec3 a, inout float b, sampler2D map, float h[9], vec3[4] g) { return 1.0; }\n");
    ASSERT_EQ(text.functions.size(), 1U);
    const GlslFunction& f = text.functions[0];
    EXPECT_EQ(f.signature(), "f(vec3,float,sampler2D,float[9],vec3[4])");
    ASSERT_EQ(f.parameters.size(), 5U);
    EXPECT_EQ(f.parameters[0].qualifier, "in");
    EXPECT_EQ(f.parameters[1].qualifier, "inout");
    EXPECT_EQ(f.parameters[3].name, "h");
    EXPECT_EQ(f.parameters[3].count, 9);
    EXPECT_EQ(f.parameters[4].count, 4);
    EXPECT_FALSE(f.has_result_only());
}

TEST(GlslText, KnowsWhereAFunctionBeginsAndEnds) {
    const std::string text = "int x;\nprecise float f(float a) { if (a > 0.0) { return a; } return 0.0; }  // after\n";
    const GlslFunction f = parse_glsl(text).functions.at(0);
    EXPECT_EQ(text.substr(f.begin, f.end - f.begin),
              "precise float f(float a) { if (a > 0.0) { return a; } return 0.0; }");
    EXPECT_EQ(text.substr(f.name_at, 1), "f");
    EXPECT_TRUE(f.has_result_only());
}

TEST(GlslText, DistinguishesOverloads) {
    EXPECT_EQ(signatures("vec2 f(vec2 v) { return v; }\nvec3 f(vec3 v) { return v; }\nvoid g(void) {}\nvoid h() {}\n"),
              (Names{"vec2 f(vec2)", "vec3 f(vec3)", "void g()", "void h()"}));
}

TEST(GlslText, SkipsCommentsPrototypesDirectivesAndCalls) {
    EXPECT_EQ(signatures(
                  "// float a() { }\n/* float b() {\n} */\nfloat c(float x);\n#define D(x) \\\n  float d(float x) { }\n"
                  "float e(float /* float */ x) { return c(x) * d(x); }\n"
                  "layout(location = 0) out vec4 o_color;\nuniform Block { float f; };\n"),
              (Names{"float e(float)"}));
}

TEST(GlslText, TakesBothBranchesOfACondition) {
    EXPECT_EQ(signatures("#ifdef A\nvoid f(int i) { }\n#else\nint f() { return 1; }\n#endif\n"),
              (Names{"void f(int)", "int f()"}));
}

TEST(GlslText, FindsStructsAndTheirFields) {
    const GlslText text = parse_glsl(
        "struct Ray {\n    vec3 origin, direction;  // metres\n    float level[2];\n};\n"
        "Ray turned(Ray ray) { return ray; }\n");
    ASSERT_EQ(text.structs.size(), 1U);
    const std::vector<GlslVariable>& fields = text.structs[0].fields;
    ASSERT_EQ(fields.size(), 3U);
    EXPECT_EQ(fields[1].type + " " + fields[1].name, "vec3 direction");
    EXPECT_EQ(fields[2].count, 2);
    ASSERT_EQ(text.functions.size(), 1U);
    EXPECT_EQ(text.functions[0].type, "Ray");
}

TEST(GlslText, SurvivesTruncatedText) {
    for (const char* const text :
         {"float f(", "float f() {", "struct S {", "struct S { float", "struct", "layout(", "/* ", "#", "f(a[", "("})
        EXPECT_NO_THROW(parse_glsl(text)) << text;
}

TEST(GlslText, ReadsNumbersWhole) {
    Names words;
    for (const CodeToken& token : code_tokens("a=1.0e-3+.5f-2;")) words.push_back(token.text);
    EXPECT_EQ(words, (Names{"a", "=", "1.0e-3", "+", ".5f", "-", "2", ";"}));
}

std::string kinds_of_tokens(const std::string& text) {
    std::string list;
    for (const CodeToken& token : all_tokens(text)) list += "wnslcd"[token.kind];
    return list;
}

TEST(CodeText, TokensCommentsAndDirectivesHaveTheirPlace) {
    const std::string text = "#define A /* two\nlines */ 1 // end\n/* a */ x += \"a//b\\\"c\" 'd' // e";
    EXPECT_EQ(kinds_of_tokens(text), "dcwssllc");
    std::string rebuilt;
    for (const CodeToken& token : all_tokens(text)) {
        while (rebuilt.size() < token.begin) rebuilt += text[rebuilt.size()];
        EXPECT_EQ(token.begin, rebuilt.size());
        rebuilt += token.text;
        EXPECT_EQ(token.end, rebuilt.size());
    }
    EXPECT_EQ(rebuilt, text);
    Names words;
    for (const CodeToken& token : tokens_of_directive(all_tokens(text).at(0))) words.push_back(token.text);
    EXPECT_EQ(words, (Names{"#", "define", "A", "1"}));
}

TEST(CodeText, ABackslashJoinsLines) {
    const std::string text = "uni\\\nform x;\n// a \\\r\n b\n#define C \\\n 1\ny";
    const std::vector<CodeToken> tokens = all_tokens(text);
    EXPECT_EQ(kinds_of_tokens(text), "wwscdw");
    EXPECT_EQ(tokens.at(0).text, "uniform");
    EXPECT_EQ(text.substr(tokens.at(0).begin, tokens.at(0).end - tokens.at(0).begin), "uni\\\nform");
    EXPECT_EQ(tokens.at(4).text, "#define C  1");
}

TEST(CodeText, ALineEndsAtACarriageReturnToo) { EXPECT_EQ(kinds_of_tokens("// a\rb;\r\n#if 1\rc 'd\re"), "cwsdwlw"); }

TEST(CodeText, NumbersHaveExponentsSuffixesAndSeparators) {
    EXPECT_EQ(kinds_of_tokens("1.0e-3f .5 0x1e+2 1'000 a.x"), "nnnsnnwsw");
}

TEST(CodeText, SurvivesTextThatEndsEarly) {
    for (const char* const text :
         {"", "/*", "//", "\"", "'\\", "#", "#define A \\", "\\", "\\\n", "1e", "\xef\xbb\xbf", "0x"})
        EXPECT_NO_THROW(all_tokens(text)) << text;
    EXPECT_EQ(kinds_of_tokens("\xef\xbb\xbf#version 410 core"), "d");
}

}  // namespace
}  // namespace relief
