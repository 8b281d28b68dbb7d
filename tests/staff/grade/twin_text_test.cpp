// Twins of shader functions: their text, the precision of the GLSL functions that they call, and their wrappers.
#include "framework/staff/grade/twin_text.h"

#include <fmt/format.h>

#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/core/gl/program.h"
#include "framework/core/gl/target.h"
#include "tests/support.h"

namespace relief::grade {
namespace {

namespace fs = std::filesystem;

TEST(TwinText, UsesDoublesForFloatsAndItsOwnNames) {
    const check::TwinText twin = twin_text(
        "#include \"common/unfinished.glsl\"\n"
        "const float least = 0.5f;\n"
        "struct Ray { vec3 origin; float level; };\n"
        "flat in int v_index;\n"
        "float f(vec2 v, int i, float h[3]) { return least * sin(v.x) * 1e-3 + float(i); }\n"
        "Ray g(mat3 m) { Ray ray = Ray(m[0], f(vec2(1.0), v_index, float[](1., 2., 3.))); ray.level *= 2.0; return "
        "ray; }\n",
        "");
    EXPECT_TRUE(contains(twin.declarations, "const double least_relief_twin = 0.5lf;")) << twin.declarations;
    EXPECT_TRUE(contains(twin.declarations, "struct Ray_relief_twin { dvec3 origin; double level; };"));
    EXPECT_TRUE(contains(twin.declarations, "double f_relief_twin(in dvec2 v, in int i, in double h[3]);"));
    EXPECT_TRUE(contains(twin.functions, "return least_relief_twin * relief_sin(v.x) * 1e-3lf + double(i);"))
        << twin.functions;
    EXPECT_TRUE(contains(twin.functions,
                         "Ray_relief_twin ray = Ray_relief_twin(m[0], f_relief_twin(dvec2(1.0lf), v_index, "
                         "double[](1.lf, 2.lf, 3.lf)));"))
        << twin.functions;
    EXPECT_FALSE(contains(twin.functions, "flat in")) << "what passes between stages is there already";
    EXPECT_FALSE(contains(twin.functions, "#include"));
    EXPECT_EQ(twin.signatures, (std::set<std::string>{"f(vec2,int,float[3])", "g(mat3)"}));
}

/// Evaluates a function of twin.glsl at 512 places from `low` to `high`. Returns the largest error against `exact`,
/// relative to the value. For values below 1 the error is absolute.
double largest_error(const std::string& call, double low, double high, const std::function<double(double)>& exact) {
    constexpr int count = 512;
    const std::string helpers = read_file(course_root() / "framework/staff/grade/twin.glsl");
    const Program program(std::vector<ShaderSource>{
        {"window.vert",
         "#version 410 core\nvoid main() { gl_Position = vec4(ivec2(gl_VertexID & 1, gl_VertexID >> 1) * 4 - 1, 0.0, "
         "1.0); }\n",
         {},
         {}},
        {"values.frag",
         fmt::format("#version 410 core\n#define RELIEF_FRAGMENT_STAGE\n{}\nlayout(location = 0) out vec4 o_color;\n"
                     "void main() {{\n    double x = {:.17e}lf + ({:.17e}lf) * double(gl_FragCoord.x - 0.5);\n"
                     "    double y = {};\n    precise float high = float(y);\n    precise float low = float(y - "
                     "double(high));\n"
                     "    o_color = vec4(high, low, 0.0, 1.0);\n}}\n",
                     helpers, low, (high - low) / (count - 1), call),
         {},
         {}}});
    const Target target(TargetKind::probe, {count, 1});
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
    glViewport(0, 0, count, 1);
    glDisable(GL_DEPTH_TEST);
    const VertexArrayName nothing;
    glBindVertexArray(nothing);
    glUseProgram(program);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    const Image image = target.read();
    double largest = 0;
    for (int i = 0; i < count; ++i) {
        const double x = low + (high - low) / (count - 1) * i, y = exact(x);
        const double found = double(image.pixel(i, 0)[0]) + double(image.pixel(i, 0)[1]);
        const double error = std::abs(found - y) / std::max(1.0, std::abs(y));
        largest = std::isfinite(error) ? std::max(largest, error) : 1e30;
    }
    return largest;
}

// Two floats hold 48 bits of a result, a relative error of 4e-15. The functions themselves keep a few bits more.
TEST(TwinFunctions, KeepFourteenDigits) {
    const struct {
        const char* call;
        double low, high;
        double (*exact)(double);
    } cases[] = {
        {"relief_exp(x)", -80, 80, [](double x) { return std::exp(x); }},
        {"relief_exp2(x)", -20, 20, [](double x) { return std::exp2(x); }},
        {"relief_log(x)", 1e-6, 1e6, [](double x) { return std::log(x); }},
        {"relief_log2(x)", 1e-3, 4, [](double x) { return std::log2(x); }},
        {"relief_pow(x, 2.4lf)", 0, 20, [](double x) { return std::pow(x, 2.4); }},
        {"relief_sin(x)", -20, 20, [](double x) { return std::sin(x); }},
        {"relief_cos(x)", -20, 20, [](double x) { return std::cos(x); }},
        {"relief_tan(x)", -1.5, 1.5, [](double x) { return std::tan(x); }},
        {"relief_asin(x)", -1, 1, [](double x) { return std::asin(x); }},
        {"relief_acos(x)", -1, 1, [](double x) { return std::acos(x); }},
        {"relief_atan(x)", -50, 50, [](double x) { return std::atan(x); }},
        {"relief_atan(x, -1.0lf)", -3, 3, [](double x) { return std::atan2(x, -1.0); }},
        {"relief_radians(x)", -360, 360, [](double x) { return x * 0.017453292519943295; }},
        {"relief_degrees(x)", -4, 4, [](double x) { return x * 57.29577951308232; }},
    };
    for (const auto& [call, low, high, exact] : cases)
        EXPECT_LT(largest_error(call, low, high, exact), 1e-14) << call << " from " << low << " to " << high;
}

TEST(WatchedShader, KeepsTheSourceLinesInCompilerMessages) {
    const TemporaryFolder folder;
    folder.write("task.glsl", "float half_of(float a) {\n    return 0.5 * a;\n}\n");
    const fs::path stage =
        folder.write("stage.frag",
                     "#version 410 core\n#include \"task.glsl\"\nlayout(location = 0) out vec4 o_color;\n"
                     "void main() { o_color = vec4(half_of(1.0)); }\n");
    std::vector<ShaderSource> stages = {load_shader(stage, {})};
    const std::vector<Place> before = stages[0].lines;
    std::vector<check::WatchedFunction> functions;
    ASSERT_EQ(check::watch_functions(stages, {folder.path() / "task.glsl"}, {}, functions), std::vector<int>{0});
    EXPECT_EQ(functions[0].signature, "half_of(float)");
    EXPECT_EQ(functions[0].place.line, 1);
    // Each line of the text has a place. The original lines keep their places and their order.
    EXPECT_EQ(std::count(stages[0].text.begin(), stages[0].text.end(), '\n'), std::ptrdiff_t(stages[0].lines.size()));
    std::istringstream text(stages[0].text);
    std::string line;
    for (size_t i = 0; std::getline(text, line); ++i) {
        if (contains(line, "return 0.5 * a;")) {
            EXPECT_EQ(stages[0].lines[i].line, 2);
        } else if (contains(line, "relief_main()") && contains(line, "half_of")) {
            EXPECT_EQ(stages[0].lines[i].line, 4);
        }
    }
    size_t kept = 0;
    for (const Place& place : stages[0].lines)
        if (kept < before.size() && place.file == before[kept].file && place.line == before[kept].line) ++kept;
    EXPECT_EQ(kept, before.size());
}

TEST(WatchedShader, KeepsProgramsWithoutTaskFunctionsUnchanged) {
    std::vector<check::WatchedFunction> functions;
    std::vector<ShaderSource> stages = {{"a.vert", "#version 410 core\nvoid main() {}\n", {}, {}}};
    EXPECT_TRUE(check::watch_functions(stages, {"task.glsl"}, {}, functions).empty());
    EXPECT_EQ(stages[0].text, "#version 410 core\nvoid main() {}\n");
}

}  // namespace
}  // namespace relief::grade
