// A task's shader may contain only its functions. Text that could change the lab's other shaders is refused, other text
// is not.
#include "framework/course/task/rules.h"

#include <optional>
#include <set>

#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/core/gl/shader_source.h"
#include "tests/support.h"

namespace relief::check {
namespace {

TEST(TaskRules, RejectsATaskThatChangesOrReadsTheLabsShaders) {
    OtherShaders others;
    others.add(
        "uniform vec3 u_eye; // see secret\nvec3 lit(vec3 n) { return max(n, 0.0); }\nvoid main() { o_color = "
        "lit(u_eye); }");
    const auto said = [&](const std::string& more) {
        return broken_rule("float f(in float x) { return x; }\n" + more, others);
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

TEST(TaskRules, RejectsATaskThatDistinguishesThePrograms) {
    OtherShaders others;
    others.add(
        "#define SIZE 3\n#if defined PROBE_uv || METHOD == 2\n#endif\n#ifdef SIZE\n#elif WIRE\n#endif\nvoid main() {}");
    const auto said = [&](const std::string& text) { return broken_rule(text, others); };
    const auto refused = [](const std::string& word) {
        return "has '" + word + "', by which the lab tells its programs apart: a task is the same in all of them";
    };
    EXPECT_EQ(said("#ifdef PROBE_uv\n#endif\n"), refused("PROBE_uv"));
    EXPECT_EQ(said("#if 1 && !defined(WIRE)\n#endif\n"), refused("WIRE"));
    EXPECT_EQ(said("struct METHOD { float x; };\n"), refused("METHOD")) << "defined, it would be another struct";
    EXPECT_EQ(said("#ifdef PROBE_guessed\n#endif\n"), refused("PROBE_guessed"));
    EXPECT_EQ(said("#if __LINE__ > 9\n#endif\n"), refused("__LINE__")) << "it counts what is defined before";
    EXPECT_EQ(said("#ifdef SIZE\n#endif\n#ifdef MINE\n#endif\n// PROBE_uv\n"), "")
        << "the shaders' own, and a student's";
}

TEST(TaskRules, RejectsMacrosThatFormNamesOrRedefineBuiltins) {
    OtherShaders others;
    others.add("void main() { o_color = vec4(max(u_x, 0.0)); }");
    const auto said = [&](const std::string& text) { return broken_rule(text, others); };
    EXPECT_EQ(said("#define J(a, b) a##b\nJ(uni, form) vec3 x;\n"), "has '##': write each name as a whole");
    const std::string refused = "has 'max' in a macro, without a '(' after it: that may define the function anew";
    EXPECT_EQ(said("#define J(f) float f(float a, float b) { return a; }\nJ(max)\n"), refused);
    EXPECT_EQ(said("#define J(t, f, a) t f(a)\nJ(float, max, float a) { return a; }\n"), refused);
    EXPECT_EQ(said("#define J max\nfloat J(float a, float b) { return a; }\n"), refused);
    EXPECT_EQ(said("#define POSITIVE(x) max((x), 0.0)\nfloat f(float max) { return g(max, POSITIVE(1.0)); }\n"), "");
}

TEST(TaskRules, EveryStageHasTheHarnessBeforeTheTask) {
    size_t stages = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(course_root() / "shaders")) {
        const std::string kind = entry.path().extension();
        if (!std::set<std::string>{".vert", ".tesc", ".tese", ".geom", ".frag"}.contains(kind)) continue;
        std::optional<size_t> task, harness;
        const ShaderSource source = load_shader(entry.path(), {});
        for (size_t i = source.lines.size(); i > 0; --i) {
            const std::filesystem::path& file = source.lines[i - 1].file;
            if (file.filename() == "task.glsl") task = i;
            if (file.filename() == "unfinished.glsl") harness = i;
        }
        if (!task) continue;
        ++stages;
        // A function of the same name in the task is then a redefinition, which the compiler refuses.
        EXPECT_LT(harness.value_or(*task), *task) << entry.path();
    }
    EXPECT_GE(stages, 30u);
}

TEST(TaskRules, RejectsIncludesThatAreNotPartOfTheTask) {
    const OtherShaders others(LabEntry{5, "tangent_basis", "05_tangent_basis"},
                              load_manifest(course_root() / "labs/05_tangent_basis/lab.toml"));
    EXPECT_EQ(broken_rule("#include \"common/unfinished.glsl\"\n#include \"common/perpendicular.glsl\"\n", others), "");
    EXPECT_EQ(broken_rule("#include \"common/perpendicular.glsl\"\n", OtherShaders()),
              "includes common/perpendicular.glsl, which is not part of this task");
}

TEST(TaskRules, RejectsACppTaskThatReachesForTheTextOfAFile) {
    const auto said = [](const std::string& line) {
        const auto fault =
            fault_of_task("#include \"task.h\"\n#include <cmath>\n" + line + "\nint after;\n", "a/task.cpp");
        EXPECT_TRUE(!fault || fault->line == 3) << line;
        EXPECT_TRUE(!fault || fault->quote.starts_with("    " + line.substr(0, line.find('\n')) + "\n")) << line;
        return fault ? fault->message : "";
    };
    for (const std::string word : {"asm", "__asm", "__asm__"}) {
        const std::string refused = "has '" + word + "', which can read files: a task is C++ alone";
        EXPECT_EQ(said(word + "(\"nop\");"), refused);
        EXPECT_EQ(said("#define READ " + word), refused);
    }
    EXPECT_EQ(said("as\\\nm(\"nop\");"), "has 'asm', which can read files: a task is C++ alone");
    EXPECT_EQ(said("const char* self = __FILE__;"), "has '__FILE__', which can read files: a task is C++ alone");
    EXPECT_EQ(said("#include __FILE__"), "has '__FILE__', which can read files: a task is C++ alone");
    EXPECT_EQ(said("[[gnu::section(\"a\\n.incbin \\\"b\\\"\")]] int x;"),
              "has '.incbin', by which an assembler reads files: a task is C++ alone");
    EXPECT_EQ(said("#define JOIN(a, b) a##b"), "has '##': write each name as a whole");
    EXPECT_EQ(said("%:include \"/x\""), "has '%:': write it as '#'");
    EXPECT_EQ(said("auto text = R\"(\")\";"), "has a raw string: write it as a plain one");
    EXPECT_EQ(said("#embed \"task.cpp\""), "has '#embed', which reads a file: a task includes headers only");
    EXPECT_EQ(said("#include HEADER"), "has an '#include' without the name of a header");
    EXPECT_EQ(said("#include_next <cmath>"), "has an '#include_next' without the name of a header");
    for (const std::string path : {"/etc/passwd", "../staff/truth.cpp", "a/../../b.h"}) {
        const std::string refused =
            "includes " + path + ": a task includes headers of the course by their names, without '..'";
        EXPECT_EQ(said("#include \"" + path + "\""), refused);
        EXPECT_EQ(said(" # include <" + path + ">"), refused);
    }
    for (const std::string honest :
         {"// asm(\"\") ## __FILE__", "int asm_, section = 1 % 2;", "#include \"framework/library/mesh/frame.h\" // ..",
          "const char* text = \"asm ## R\";", "#define HALF(x) (0.5 * (x))", "int R = 7, x = R % R;"})
        EXPECT_EQ(said(honest), "") << honest;
    EXPECT_FALSE(fault_of_task("float asm_of() { return 1.0; }\n", "a/task.glsl"));
}

TEST(TaskRules, AcceptsEveryTaskOfTheCourse) {
    size_t files = 0;
    for (const auto& lab : std::filesystem::directory_iterator(course_root() / "labs")) {
        if (!std::filesystem::exists(lab.path() / "lab.toml")) continue;
        const Manifest manifest = load_manifest(lab.path() / "lab.toml");
        const OtherShaders others(LabEntry{0, "", lab.path().filename()}, manifest);
        std::set<std::string> shaders;
        for (const TaskInfo& task : manifest.tasks)
            if (is_shader(task.file))
                shaders.insert(task.file);
            else
                EXPECT_FALSE(fault_of_task(read_file(course_root() / task.file), task.file)) << task.file;
        for (const std::string& file : shaders) {
            EXPECT_EQ(broken_rule(read_file(course_root() / file), others), "") << file;
            ++files;
        }
    }
    EXPECT_GE(files, 18u);
}

}  // namespace
}  // namespace relief::check
