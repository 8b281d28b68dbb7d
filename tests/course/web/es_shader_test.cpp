// GLSL 4.10 in ES 3.00: the conversions, and that lines keep their numbers.
#include "framework/course/web/es_shader.h"

#include <gtest/gtest.h>

namespace relief::web {
namespace {

constexpr const char* version = "#version 410 core\n";

/// Returns a converted text without the lines that es_shader() puts in front of it.
std::string body(const std::string& text, EsStage stage) {
    const std::string converted = es_shader(version + text, stage), mark = "#line 2\n";
    const size_t at = converted.find(mark);
    EXPECT_NE(at, std::string::npos);
    return converted.substr(at + mark.size());
}

TEST(EsShader, EveryLineKeepsItsNumber) {
    const std::string text =
        "#extension GL_ARB_conservative_depth : enable\n"
        "layout(depth_greater)\n"
        "    out float gl_FragDepth;\n"
        "uniform float u_here;\n";
    EXPECT_EQ(body(text, EsStage::fragment), "\n\n\nuniform float u_here;\n");
    EXPECT_TRUE(es_shader(version + text, EsStage::fragment).starts_with("#version 300 es\n"));
}

TEST(EsShader, WholeNumbersFromAVertexStageAreFlat) {
    EXPECT_EQ(
        body("out int v_index;\nout uvec2 v_codes;\nout vec3 v_normal;\nflat out int v_other;\n", EsStage::vertex),
        "flat out int v_index;\nflat out uvec2 v_codes;\nout vec3 v_normal;\nflat out int v_other;\n");
}

TEST(EsShader, OutputsInsideOfFunctionsAndOfFragmentsStay) {
    const std::string function = "void split(out int low, out int high) { low = high = 1; }\n";
    EXPECT_EQ(body(function, EsStage::vertex), function);
    EXPECT_EQ(body("out int o_index;\n", EsStage::fragment), "out int o_index;\n");
}

TEST(EsShader, NumbersInDoublePrecisionLoseTheirSuffix) {
    EXPECT_EQ(body("const double small = 1e-9lf, half_ = 0.5LF;  // 1.0lf\n", EsStage::fragment),
              "const double small = 1e-9, half_ = 0.5;  // 1.0lf\n");
    EXPECT_NE(es_shader(std::string(version) + "double x;\n", EsStage::fragment).find("#define double float\n"),
              std::string::npos);
}

TEST(EsShader, AMissingFunctionIsDefinedIfItIsCalled) {
    const auto defines = [](const std::string& text, EsStage stage) {
        return es_shader(version + text, stage).find("int findMSB(uint bits)") != std::string::npos;
    };
    EXPECT_TRUE(defines("int f(int x) { return findMSB(x); }\n", EsStage::vertex));
    EXPECT_FALSE(defines("int f(int x) { return x; }  // not findMSB(x)\n", EsStage::vertex));
    const std::string query = "float f(vec2 uv) { return textureQueryLod(s, uv).y; }\n";
    EXPECT_NE(es_shader(version + query, EsStage::fragment).find("vec2 textureQueryLod("), std::string::npos);
    EXPECT_EQ(es_shader(version + query, EsStage::vertex).find("vec2 textureQueryLod("), std::string::npos);
}

TEST(EsShader, ALoopThatMayNotEndHasALimitOfRounds) {
    const auto limited = [](const std::string& text) { return "void f() { " + text + " }\n"; };
    const auto loop = [&](const std::string& text) {
        const std::string converted = es_shader(version + limited(text), EsStage::fragment, limited(text));
        return converted.substr(converted.find("#line 2\n") + 8);
    };
    const std::pair<const char*, const char*> loops[] = {
        {"while (true) ++x;", "while (relief_goes_on() && (true)) ++x;"},
        {"for (;;) {}", "for (;relief_goes_on();) {}"},
        {"do { ++x; } while (x < f(3));", "do { ++x; } while (relief_goes_on() && (x < f(3)));"},
        {"for (int i = 0; i < n; ++i) ++x;", "for (int i = 0; relief_goes_on() && (i < n); ++i) ++x;"},
        {"for (int i = 0; i < 99999999; ++i) ++x;", "for (int i = 0; relief_goes_on() && (i < 99999999); ++i) ++x;"},
        {"const int n = 99999; for (int i = 0; i < n; ++i) ++x;",
         "const int n = 99999; for (int i = 0; relief_goes_on() && (i < n); ++i) ++x;"},
        {"for (int i = 0; i < 8; ++i) if (x > 0) { i = 0; }",
         "for (int i = 0; relief_goes_on() && (i < 8); ++i) if (x > 0) { i = 0; }"},
        {"for (int i = 0; i < 8; ++i) { --i; }", "for (int i = 0; relief_goes_on() && (i < 8); ++i) { --i; }"},
        {"for (int i = 0; i < 8; ++i) { i -= 1; }", "for (int i = 0; relief_goes_on() && (i < 8); ++i) { i -= 1; }"},
    };
    for (const auto& [text, expected] : loops) EXPECT_EQ(loop(text), limited(expected));
    // These end, and a compiler may have to unroll them.
    for (const char* const text :
         {"for (int i = 0; i < 8; ++i) x += i == 3 ? 1 : i - 1;", "for (int i = 0; i <= 8; i++) {}",
          "const int n = 8; for (int i = 0; i < n; ++i) { a[i] = 1; }"})
        EXPECT_EQ(loop(text), limited(text));
    EXPECT_NE(es_shader(version + limited("for ("), EsStage::vertex, "for"), "");
}

TEST(EsShader, LoopsInMacrosOfATaskFileHaveALimitAndKeepTheirLines) {
    const std::string task =
        "#define FOREVER while (true)\n#define ADD(n) for (int i = 0; i < n; ++i) \\\n    ++x;\n#define TWO 2\n"
        "void f() { FOREVER ADD(3) }\n";
    const std::string text = es_shader(version + task, EsStage::fragment, task);
    EXPECT_EQ(text.substr(text.find("#line 2\n") + 8),
              "#define FOREVER while (relief_goes_on() && (true))\n"
              "#define ADD(n) for (int i = 0; relief_goes_on() && (i < n); ++i)     ++x;\n\n#define TWO 2\n"
              "void f() { FOREVER ADD(3) }\n");
}

TEST(EsShader, OnlyTheLoopsOfATaskFileHaveALimit) {
    const std::string task = "#include \"common/unfinished.glsl\"\nvoid f() { while (true) {} }\n";
    const std::string own = task.substr(task.find('\n') + 1), other = "void g() { while (true) {} }\n";
    const std::string text = es_shader(version + other + own + other, EsStage::vertex, task);
    EXPECT_NE(text.find(other + "void f() { while (relief_goes_on() && (true)) {} }\n" + other), text.npos) << text;
    EXPECT_NE(text.find("bool relief_goes_on() { return ++relief_rounds < 8192; }\n"), text.npos);
    EXPECT_EQ(es_shader(version + other, EsStage::vertex).find("relief_goes_on"), std::string::npos);
}

TEST(EsShader, AVertexStageCanMoveItsPositions) {
    const std::string text = "void main() { gl_Position = vec4(0); }\n",
                      moving = es_shader(version + text, EsStage::vertex);
    const size_t renamed = moving.find("#define main relief_main\n"), line = moving.find("#line 2\n"),
                 restored = moving.find("#undef main\n");
    EXPECT_LT(renamed, line);
    EXPECT_LT(line, restored);
    EXPECT_NE(moving.find("gl_Position.xy += relief_move * gl_Position.w;", restored), std::string::npos);
    EXPECT_EQ(body(text, EsStage::fragment), text);
}

TEST(EsShader, AnEmptyTextIsConverted) { EXPECT_NE(es_shader("", EsStage::vertex), ""); }

TEST(EsLog, ImplicitConversionsAreExplained) {
    const std::string wrong = "ERROR: 0:12: '*' : wrong operand types - 'const int' and 'highp float'",
                      other = "ERROR: 0:13: 'interval' : undeclared identifier";
    EXPECT_EQ(es_log(wrong + "\n" + other + "\n"),
              wrong + " (in a browser, write 2.0 instead of 2 where a float is wanted)\n" + other + "\n");
}

}  // namespace
}  // namespace relief::web
