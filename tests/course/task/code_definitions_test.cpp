// Definitions found in GLSL and C++ texts.
#include "framework/course/task/code_definitions.h"

#include "tests/support.h"

namespace relief {
namespace {

/// Returns the kinds and names of a text's definitions, such as "f gap, v a b".
std::string kinds_and_names(const std::string& text) {
    std::string list;
    for (const CodeDefinition& one : definitions_of(text).list) {
        list += std::string(list.empty() ? "" : ", ") + "fptvmdos"[one.kind];
        for (const std::string& name : one.names) list += " " + name;
    }
    return list;
}

TEST(CodeDefinitions, HaveKindsAndNames) {
    EXPECT_EQ(kinds_and_names(
                  "#include \"x\"\n#define A(x) (x)\nstruct Ray { vec2 uv, march; };\nconst int a = 1, b[2] = {1, 2};\n"
                  "float f(float);\nfloat f(float x) { if (x > 0.0) { return 1.0; } return a; }\nint c;\n"),
              "d, m A, t Ray, v a b, p f, f f, v c");
    EXPECT_EQ(
        kinds_and_names(
            "using namespace std;\nusing Real = double;\nnamespace a::b {\nnamespace {\ndouble g(Real x) { return "
            "x; }\n}\nconst auto h = [](double x) { return x; };\nstd::array<double, 2> i{1, 2};\n}\n"),
        "o, v Real, f g, v h, v i");
}

TEST(CodeDefinitions, KnowTheirConditionsInAndAfterNamespaces) {
    const auto list = definitions_of(
                          "namespace a::b { namespace { int f() { return 1; } } }\n"
                          "#ifdef X\n#if 0\nint dead() { return 1; }\n#endif\nint g() { return 1; }\n"
                          "#else\nint h() {\n#if Y\nreturn 2;\n#endif\nreturn 1; }\n#endif\nint i;\n")
                          .list;
    ASSERT_EQ(list.size(), 4u);
    EXPECT_EQ(list[0].names, std::vector<std::string>{"f"});
    EXPECT_EQ(list[1].conditions, std::vector<std::string>{"#ifdef X"});
    EXPECT_EQ(list[2].conditions, std::vector<std::string>{"#ifdef X\n#else"});
    EXPECT_TRUE(list[3].conditions.empty());
}

TEST(CodeDefinitions, ExtentsAreRangesOfTheText) {
    const std::string text = "// a\nconst float x = 1.0; // b\n\nfloat f(float a)  // c\n{ return a; } int d;";
    const auto list = definitions_of(text).list;
    ASSERT_EQ(list.size(), 3u);
    EXPECT_EQ(text.substr(list[0].begin, list[0].end - list[0].begin), "const float x = 1.0;");
    EXPECT_EQ(text.substr(list[1].begin, list[1].end - list[1].begin), "float f(float a)  // c\n{ return a; }");
    EXPECT_EQ(text[list[1].body], '{');
}

TEST(CodeSignature, HasTypesOnly) {
    const auto text = [](const char* definition) { return definitions_of(definition).list.at(0).signature.text(); };
    EXPECT_EQ(text("float f(const in vec3 a, float h[9], float[2] g, sampler2D) { return 1.0; }"),
              "f(const vec3, float[9], float[2], sampler2D)");
    EXPECT_EQ(text("double g(const std::array<double, 16>& values, glm::dvec3 const& a = {}, int b = 2) { return 1; }"),
              "g(const std::array<double, 16>&, glm::dvec3 const&, int)");
    EXPECT_EQ(text("void h(void) {}"), "h()");
    EXPECT_EQ(parse_signature("solve(const Triangle&, double)").text(), "solve(const Triangle&, double)");
}

TEST(CodeSignature, FitsOtherNamesOfItsTypesButNoOtherTypesOfTheLanguage) {
    const CodeSignature asked = parse_signature("f(float, const glm::dvec3&, float[9])");
    for (const char* good : {"f(float, glm::dvec3 const&, float[9])", "f(real, dvec3, float[count])"})
        EXPECT_TRUE(asked.fits(parse_signature(good))) << good;
    for (const char* bad :
         {"f(int, dvec3, float[9])", "f(float, dvec3)", "g(float, dvec3, float[9])", "f(float, dvec3, float)"})
        EXPECT_FALSE(asked.fits(parse_signature(bad))) << bad;
}

TEST(CodeDefinitions, WithABracketTooFewOrTooManyTheNextFunctionIsFound) {
    const std::string after = "float g(float x) { return x; }\nvec2 h(vec2 a,\n       vec2 b) {\n    return a;\n}\n";
    for (const char* broken :
         {"float f(float x) {\n    if (x > 0.0) {\n        return 1.0;\n}\n",
          "float f(float x) {\n    return max(x, 1.0;\n}\n", "float f(float x {\n    return x;\n}\n"})
        EXPECT_EQ(kinds_and_names(broken + after), "f f, f g, f h") << broken;
    EXPECT_EQ(kinds_and_names("float f(float x) {\n    x = 1.0; }\n    return x;\n}\n" + after), "f f, s, s, f g, f h");
    EXPECT_FALSE(definitions_of("float f() {").is_balanced);
    EXPECT_TRUE(definitions_of(after).is_balanced);
}

TEST(CodeDefinitions, SurviveTextThatEndsEarly) {
    for (const char* const text : {"float f(", "float f() {", "struct S {", "#if", "#else", "namespace {", "}", ")",
                                   "= ;", "f(a[", "(", "template <", "#if 0\n#else", "using"})
        EXPECT_NO_THROW(definitions_of(text)) << text;
    for (const char* const text : {"", "f", "f(", "f()", "f(,)", "()"}) EXPECT_NO_THROW(parse_signature(text)) << text;
}

}  // namespace
}  // namespace relief
