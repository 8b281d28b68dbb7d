// A task's shader is its functions: what would change the lab's other shaders is refused, and nothing else.
#include "framework/check/reach.h"

#include "framework/base/file.h"
#include "framework/base/paths.h"
#include "tests/support.h"

namespace relief {
namespace {

TEST(Reach, IsRefusedWhereAShaderWouldChangeOrReadTheRest) {
    OtherShaders others;
    others.add(
        "uniform vec3 u_eye; // see secret\nvec3 lit(vec3 n) { return max(n, 0.0); }\nvoid main() { o_color = "
        "lit(u_eye); }");
    const auto said = [&](const std::string& more) {
        return reaches_beyond("float f(in float x) { return x; }\n" + more, others);
    };
    for (const std::string honest :
         {"", "#define PI 3.14\n#define secret 1\n",
          "float g(const in float x, out float y, inout vec3 z) { return max(x, y); }",
          "float lit2(vec3 n) { return lit(n).x; }", "float u = 1.0; // uniform in\n/* layout */", "#undef PI\n"})
        EXPECT_EQ(said(honest), "") << honest;
    for (const std::string macro : {"#define main mine\n", " # /* a */ define main() mine()\n",
                                    "#def\\\nine main mine\n", "#define ma\\\r\nin mine\n", "#undef main\n"})
        EXPECT_EQ(said(macro), "defines 'main', which the lab's shaders use") << macro;
    EXPECT_EQ(said("#define vec3 vec4\n"), "defines 'vec3', which the lab's shaders use");
    EXPECT_EQ(said("vec3 max(vec3 a, float b) { return a; }"),
              "defines 'max', a function of the language that the lab's shaders call");
    for (const std::string word : {"uniform", "in", "out", "layout"}) {
        const std::string refused =
            "has '" + word + "' outside of a function: what a shader reads and writes is the lab's";
        EXPECT_EQ(said(word + " vec3 u_other;"), refused);
        EXPECT_EQ(said("#define mine " + word + "\nmine vec3 u_other;"), refused);
        EXPECT_EQ(said("\n#if 0\n(\n#endif\n" + word + " vec3 u_other;"), refused) << "brackets hide nothing";
    }
}

TEST(Reach, IsRefusedWhereAShaderIncludesWhatItsTaskHasNot) {
    const OtherShaders others(LabEntry{5, "tangent_basis", "05_tangent_basis"},
                              load_manifest(course_root() / "labs/05_tangent_basis/lab.toml"));
    EXPECT_EQ(reaches_beyond("#include \"common/unfinished.glsl\"\n#include \"common/perpendicular.glsl\"\n", others),
              "");
    EXPECT_EQ(reaches_beyond("#include \"common/perpendicular.glsl\"\n", OtherShaders()),
              "includes common/perpendicular.glsl, which is not part of this task");
}

TEST(Reach, OfTheCoursesOwnTasksIsNoneRefused) {
    size_t files = 0;
    for (const auto& lab : std::filesystem::directory_iterator(course_root() / "labs")) {
        if (!std::filesystem::exists(lab.path() / "lab.toml")) continue;
        const Manifest manifest = load_manifest(lab.path() / "lab.toml");
        const OtherShaders others(LabEntry{0, "", lab.path().filename()}, manifest);
        std::set<std::string> shaders;
        for (const TaskInfo& task : manifest.tasks)
            if (is_shader(task.file)) shaders.insert(task.file);
        for (const std::string& file : shaders) {
            EXPECT_EQ(reaches_beyond(read_file(course_root() / file), others), "") << file;
            ++files;
        }
    }
    EXPECT_GE(files, 18u);
}

}  // namespace
}  // namespace relief
