// The messages of compilers about a shader. Those of Mesa 22.3 are as it writes them for these texts.
#include <gtest/gtest.h>

#include "framework/core/base/folded_text.h"
#include "framework/core/base/text.h"
#include "framework/core/gl/shader_source.h"
#include "tests/process.h"
#include "tests/support.h"

namespace relief {
namespace {

/// A stage of ten lines whose fourth to sixth come from an include, with one #define.
const std::vector<Place> ten_lines = {{"a.frag", 1},     {},
                                      {"a.frag", 2},     {"light.glsl", 1},
                                      {"light.glsl", 2}, {"light.glsl", 3},
                                      {"a.frag", 4},     {"a.frag", 5},
                                      {"a.frag", 6},     {"a.frag", 7}};

/// An explained log with its parts apart.
struct Parts {
    Place first;
    std::string message, details;
    std::vector<std::string> further;
};
Parts parts_of(const ShaderLog& log) {
    const FoldedText parts = unfolded_text(log.text);
    return {log.first, log.first_message, parts.shown, parts.folded};
}

Parts explain(const std::string& log, const std::string& text = "1\n2\n3\n4\n5\n6\n7\n8\n9\n10\n") {
    return parts_of(explain_log(log, ten_lines, text));
}

/// A stage whose first lines are the lab's, then a task's file with this text, then the lab's `after`. `log` may
/// contain
/// "@N" for line N of the task, and "#N" for line N of `after`.
Parts in_task(const std::string& task, std::string log, const std::string& after = "void main() { }\n") {
    ShaderSource source;
    const auto add = [&](const std::string& text, const char* file) {
        std::vector<std::string> lines = split(text, '\n');
        lines.pop_back();
        for (size_t i = 0; i < lines.size(); ++i) {
            source.text += lines[i] + "\n";
            source.lines.push_back({file, int(i) + 1});
        }
    };
    add("#version 410 core\nin vec3 v_tangent;\nuniform float u_scale;\nvec3 shade(vec3 light) { return light; }\n",
        "surface.vert");
    const int task_begins = int(source.lines.size());
    add(task, "task.glsl");
    const int after_begins = int(source.lines.size());
    add(after, "surface.frag");
    for (const auto& [mark, before] : {std::pair{'@', task_begins}, std::pair{'#', after_begins}})
        for (size_t at = log.find(mark); at != std::string::npos; at = log.find(mark))
            log.replace(at, 2, std::to_string(before + (log[at + 1] - '0')));
    return parts_of(explain_log(log, source.lines, source.text));
}

std::string place_of(const Parts& log) { return log.first.file.string() + ":" + std::to_string(log.first.line); }

TEST(ShaderLogs, AreParsedForMesaNvidiaAppleAndAmd) {
    for (const char* line : {"0:5(12): error: 'x' undeclared", "0(5) : error C1008: 'x' undeclared",
                             "ERROR: 0:5: 'x' undeclared", "0:5: error: 'x' undeclared"}) {
        const Parts log = explain(line);
        EXPECT_EQ(place_of(log), "light.glsl:2") << line;
        EXPECT_TRUE(contains(log.message, "'x' undeclared")) << line;
        EXPECT_TRUE(log.further.empty()) << line;
    }
}

TEST(ShaderLogs, TheFirstErrorIsNotAWarning) {
    for (const char* warning :
         {"0:3(1): warning: 'a' unused", "0(3) : warning C7050: 'a' unused", "WARNING: 0:3: 'a' unused"}) {
        const Parts log = explain(std::string(warning) + "\nERROR: 0:4: no such type\nERROR: 0:9: more\n");
        EXPECT_EQ(place_of(log), "light.glsl:1") << warning;
        EXPECT_EQ(log.message, "no such type") << warning;
        ASSERT_EQ(log.further.size(), 2u) << "all lines are kept";
        EXPECT_TRUE(log.further[0].starts_with("a.frag:2: ")) << log.further[0];
        EXPECT_EQ(log.further[1], "a.frag:6: more");
    }
}

TEST(ShaderLogs, AHeadingDoesNotHideTheFirstPlace) {
    const Parts log = explain("Fragment info\n-------------\n0(5) : error C1008: x\n");
    EXPECT_EQ(place_of(log), "light.glsl:2");
    EXPECT_EQ(log.message, "error C1008: x");
    EXPECT_EQ(log.further, (std::vector<std::string>{"Fragment info", "-------------"}));
}

TEST(ShaderLogs, LinesWithoutAKnownPlaceAreKept) {
    const Parts link = parts_of(explain_log("error: no fragment output\r\n\n", {}));
    EXPECT_EQ(link.message, "error: no fragment output");
    EXPECT_TRUE(link.first.file.empty() && link.further.empty());
    for (const char* line :
         {"0:0(0): error: x", "0:11(5): error: x", "0:99999999999(1): error: x", "0:2(1): error: x"}) {
        EXPECT_EQ(explain(line).message, "error: x") << line;
        EXPECT_TRUE(explain(line).first.file.empty()) << line;
    }
    EXPECT_EQ(explain("").message, "");
    EXPECT_EQ(explain(std::string("0:1(1): error: x\n\0", 18)).message, "error: x") << "a driver's closing zero";
    const std::string name(1 << 20, 'x');
    EXPECT_EQ(explain("0:1(1): error: `" + name + "' undeclared").first.line, 1) << "a very long name";
}

TEST(ShaderLogs, AMarkStandsBelowTheNameThatTheMessageIsAbout) {
    const auto mark = [](const std::string& line, const std::string& log) {
        return explain(log, "1\n2\n3\n4\n" + line + "\n6\n7\n8\n9\n10\n").details;
    };
    EXPECT_EQ(mark("\tx = y;", "0:5(6): error: `y' undeclared\n"), "        x = y;\n            ^\n");
    EXPECT_EQ(mark("    float /* \xc3\xa4 */ b  =   tangnt;", "0:5(12): error: `tangnt' undeclared"),
              "        float /* \xc3\xa4 */ b  =   tangnt;\n                             ^\n")
        << "Mesa counts blanks and comments that follow each other as one";
    EXPECT_EQ(mark("a = bb + b;", "0:5(1): error: `b' undeclared"), "    a = bb + b;\n             ^\n")
        << "the name, where another column is reported";
    EXPECT_EQ(mark("a = b;", "ERROR: 0:5: 'b' : undeclared identifier"), "    a = b;\n        ^\n");
    for (const char* nowhere : {"0:5(99): error: x", "0:5(0): error: x", "0:5(2): error: x"})
        EXPECT_EQ(mark("a = b;", nowhere), "    a = b;\n") << nowhere << ": no mark is better than a wrong one";
    EXPECT_EQ(explain("0:11(1): error: x").details, "");
}

TEST(ShaderLogs, NameTheNearestNameInScope) {
    const std::string task =
        "float other(float tangens) { return tangens; }\n"
        "float slope(vec3 tangent) {\n"
        "    float scale = 1.0, sharpness = 2.0;\n"
        "    return tangnt.x;\n"
        "}\n"
        "float later(float x) { return x; }\n";
    const auto told = [&](const std::string& line, const std::string& log) {
        std::string text = task;
        text.replace(text.find("    return tangnt.x;"), 20, line);
        return in_task(text, log).message;
    };
    EXPECT_EQ(told("return tangnt.x;", "0:@4(9): error: `tangnt' undeclared\n0:@4(9): error: type mismatch\n"),
              "error: `tangnt' undeclared: did you mean `tangent'?");
    EXPECT_EQ(told("return tangents;", "0:@4(9): error: `tangents' undeclared"),
              "error: `tangents' undeclared: did you mean `tangent'?")
        << "not the parameter of another function";
    EXPECT_EQ(told("return sharpnes;", "0:@4(9): error: `sharpnes' undeclared"),
              "error: `sharpnes' undeclared: did you mean `sharpness'?");
    EXPECT_EQ(told("return u_scal;", "0:@4(9): error: `u_scal' undeclared"),
              "error: `u_scal' undeclared: did you mean `u_scale'?");
    EXPECT_EQ(told("return shad(tangent).x;", "0:@4(9): error: no function with name 'shad'"),
              "error: no function with name 'shad': did you mean `shade'?");
    EXPECT_EQ(told("return normalise(tangent).x;", "0:@4(9): error: no function with name 'normalise'"),
              "error: no function with name 'normalise': did you mean `normalize'?");
    EXPECT_EQ(told("return later(1.0);", "0:@4(9): error: no function with name 'later'"),
              "error: no function with name 'later': line 6 defines it: move that above this function");
    EXPECT_EQ(told("return quotient;", "0:@4(9): error: `quotient' undeclared"), "error: `quotient' undeclared");
    EXPECT_EQ(told("return u;", "0:@4(9): error: `u' undeclared"), "error: `u' undeclared") << "too short to guess";
}

TEST(ShaderLogs, NameGlslsWordForThatOfAnotherLanguage) {
    const auto told = [](const std::string& line, const std::string& log) {
        return in_task("float f(float x) {\n" + line + "\n}\n", log);
    };
    for (const auto& [word, glsl] : std::vector<std::pair<std::string, std::string>>{{"saturate", "clamp(x, 0.0, 1.0)"},
                                                                                     {"lerp", "mix"},
                                                                                     {"mul", "the operator *"},
                                                                                     {"frac", "fract"},
                                                                                     {"rsqrt", "inversesqrt"},
                                                                                     {"ddx", "dFdx"},
                                                                                     {"atan2", "atan(y, x)"},
                                                                                     {"powf", "pow"}}) {
        const std::string said = "error: no function with name '" + word + "'";
        EXPECT_EQ(told("return " + word + "(x);", "0:@2(8): " + said).message,
                  said + (glsl.empty() ? "" : ": in GLSL it is " + glsl));
    }
    const Parts type =
        told("float3 y = float3(x);", "0:@2(8): error: syntax error, unexpected NEW_IDENTIFIER, expecting ',' or ';'");
    EXPECT_EQ(type.message, "error: syntax error, unexpected `y', expecting ',' or ';': in GLSL `float3' is vec3");
    EXPECT_EQ(type.details, "    float3 y = float3(x);\n    ^\n");
    EXPECT_EQ(told("half y = 1.0;", "0:@2(1): error: illegal use of reserved word `half'").message,
              "error: illegal use of reserved word `half': in GLSL it is float");
    EXPECT_EQ(in_task("float lerp(float x) { return x; }\nfloat f(float x) { return lerp(x, x); }\n",
                      "0:@2(29): error: no matching function for call to `lerp(float, float)'; candidates are:\n"
                      "0:@2(29): error:    float lerp(float)\n")
                  .message,
              "error: no matching function for call to `lerp(float, float)'")
        << "a function of one's own may have that name";
}

TEST(ShaderLogs, ShowFewCandidatesAndFoldMany) {
    const std::string task = "vec3 f(vec3 a, float b) { return a * b; }\nvec3 g() { return f(vec3(1.0)); }\n",
                      head = "0:@2(19): error: no matching function for call to `f(vec3)'; candidates are:\n",
                      candidate = "0:@2(19): error:    vec3 f(vec3, float)\n", end = "0:@2(19): error: type mismatch\n";
    const Parts one = in_task(task, head + candidate + end);
    EXPECT_EQ(one.message, "error: no matching function for call to `f(vec3)'");
    EXPECT_EQ(one.details,
              "    vec3 g() { return f(vec3(1.0)); }\n                      ^\n    there is vec3 f(vec3, float)\n");
    EXPECT_EQ(one.further, std::vector<std::string>{"task.glsl:2: error: type mismatch"});
    const Parts many = in_task(task, head + candidate + candidate + candidate + candidate + candidate + end);
    EXPECT_EQ(many.further.size(), 6u);
}

TEST(ShaderLogs, AMissingSemicolonIsSaidWhereItCanBe) {
    const auto told = [](const std::string& lines, const std::string& log) {
        return in_task("float f(float x) {\n" + lines + "\n}\n", log);
    };
    const std::string said = ": error: syntax error, unexpected RETURN, expecting ',' or ';'";
    const Parts missing = told("    float y = x  // why\n\n    return y;", "0:@4(2)" + said);
    EXPECT_EQ(place_of(missing), "task.glsl:2");
    EXPECT_EQ(
        missing.message,
        "error: is a ; missing at the end of this line? Line 4 has a syntax error, unexpected `return', expecting "
        "',' or ';'");
    EXPECT_EQ(missing.details, "        float y = x  // why\n                   ^\n");
    EXPECT_EQ(place_of(told("return x", "0:@3(1): error: syntax error, unexpected '}', expecting ',' or ';'")),
              "task.glsl:2");
    for (const auto& [lines, log] : std::vector<std::pair<std::string, std::string>>{
             {"float y = x +\n) return y;", "0:@3(1): error: syntax error, unexpected ')'"},
             {"float y = max(x,\n1.0;", "0:@3(4): error: syntax error, unexpected ';', expecting ')' or ','"},
             {"if (x > 0.0)\n) return y;", "0:@3(1): error: syntax error, unexpected ')'"},
             {"return x;\nelse return x;", "0:@3(1): error: syntax error, unexpected ELSE"},
             {"float y = x;\nfloat float;", "0:@3(7): error: syntax error, unexpected FLOAT"},
             {"vec3 y = float3(x)\nfloat z;", "0:@3(1): error: syntax error, unexpected FLOAT, expecting ')'"}})
        EXPECT_FALSE(contains(told(lines, log).message, "missing")) << lines;
}

TEST(ShaderLogs, BlameNoFileOfTheLabForATextThatEndsInTheMiddle) {
    const std::string said = ": error: syntax error, unexpected '{', expecting ';'";
    const Parts open =
        in_task("float f(float x) {\n    if (x > 1.0) {\n        return 2.0;\n    return x;\n}\n", "0:#1(13)" + said);
    EXPECT_EQ(place_of(open), "task.glsl:1");
    EXPECT_EQ(open.message, "error: this { is never closed");
    EXPECT_EQ(place_of(in_task("float f() {\n    return 1.0;\n\nfloat g() {\n    return 2.0;\n}\n", "0:@4(11)" + said)),
              "task.glsl:1")
        << "the function before it";
    const Parts end = in_task("float f() { return 1.0; }\nconst float g = 1.0 // why\n",
                              "0:#1(1): error: syntax error, unexpected VOID, expecting ',' or ';'");
    EXPECT_EQ(place_of(end), "task.glsl:2");
    EXPECT_TRUE(contains(end.message, "is a ; missing here?")) << end.message;
    EXPECT_EQ(end.details, "    const float g = 1.0 // why\n                       ^\n");
    EXPECT_EQ(place_of(in_task("const float g = 1.0\n", "0:#4(1): error: syntax error, unexpected VOID",
                               "#ifdef A\nfloat a;\n#endif\nvoid main() { }\n")),
              "task.glsl:1")
        << "behind a branch that is not compiled";
    EXPECT_EQ(place_of(in_task("float f() { return 1.0; }\n", "0:#2(2): error: syntax error, unexpected ','",
                               "void main() {\n  , ;\n}\n")),
              "surface.frag:2")
        << "a mistake in the lab's own file";
}

TEST(ShaderLogs, BlameNoFileOfTheLabForNamesThatTheTextChanges) {
    const std::string lab = "void main() {\n    float a = march(vec3(1.0));\n}\n";
    const Parts changed = in_task("// why\nfloat march(vec2 ray) { return ray.x; }\n",
                                  "0:#2(12): error: no matching function for call to `march(vec3)'; candidates are:\n"
                                  "0:#2(12): error:    float march(vec2)\n",
                                  lab);
    EXPECT_EQ(place_of(changed), "task.glsl:2");
    EXPECT_TRUE(contains(changed.message, "`march' does not fit its use by the lab")) << changed.message;
    EXPECT_TRUE(contains(changed.details, "surface.frag:2: error: no matching function")) << changed.details;
    const Parts missing = in_task("float ray_march(vec3 ray) { return ray.x; }\n",
                                  "0:#2(12): error: no function with name 'march'\n", lab);
    EXPECT_EQ(place_of(missing), "task.glsl:0");
    EXPECT_TRUE(contains(missing.message, "`march' is missing, which the lab calls")) << missing.message;
    const Parts misspelt =
        in_task("float ray_march(vec3 ray) { return ray.x; }\n", "0:#2(12): error: no function with name 'mox'\n",
                "void main() {\n    float a = mox(1.0, 2.0);\n}\n");
    EXPECT_EQ(place_of(misspelt), "surface.frag:2") << "the call has the mistake";
    EXPECT_TRUE(contains(misspelt.message, "did you mean `max'?")) << misspelt.message;
    const Parts again = in_task("float fog(float x) { return x; }\n", "0:#1(7): error: function `fog' redefined\n",
                                "float fog(float x) { return x; }\nvoid main() { }\n");
    EXPECT_EQ(place_of(again), "task.glsl:1");
    EXPECT_TRUE(contains(again.message, "choose another name")) << again.message;
}

TEST(ShaderLogs, FindTheFunctionThatALinkerNames) {
    const std::string text = "void main() { }\nfloat twice(float x) {\n    return twice(x - 1.0);\n}\n";
    const std::vector<Place> lines = {{"surface.vert", 1}, {"task.glsl", 5}, {"task.glsl", 6}, {"task.glsl", 7}};
    const Parts log = parts_of(explain_log("error: function `float twice(float)' has static recursion\n", lines, text));
    EXPECT_EQ(place_of(log), "task.glsl:5");
    EXPECT_TRUE(contains(log.message, "GLSL has no recursion")) << log.message;
    EXPECT_EQ(explain_log("error: x", lines, text).first.file, "");
}

TEST(ShaderLogs, SurviveTextsThatEndAnywhere) {
    const std::string text =
        "float f(float x) {\n    if (x > 1.0) { return \"lerp\" }\n#if\n/* ]) */ x.y = `z' ; struct\n";
    for (size_t size = 0; size < text.size(); ++size)
        for (const char* log : {"0:@2(9): error: `x' undeclared", "0:@1(1): error: syntax error, unexpected ')'",
                                "0:#1(1): error: no function with name 'f'", "0:#1(1): error: syntax error"})
            in_task(text.substr(0, size) + "\n", log);
}

}  // namespace
}  // namespace relief
