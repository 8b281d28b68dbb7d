// One task of a submission among the solutions of all other tasks.
#include "framework/staff/grade/transplant.h"

#include <gtest/gtest.h>

namespace relief::grade {
namespace {

const std::string solution =
    "#include x\n// TASK 1.1 (2 points): a\nint a = 1;\n\n// TASK 1.2: see TASK 1.1\nint b = 2;\n// TASK 1.10: c\nint "
    "c = 3;\n";

TEST(Transplant, TakesOneTaskAndTheTextBeforeTheFirst) {
    const std::string submitted =
        "#include x\nint mine;\n// TASK 1.1 (2 points): a\nint a = 10;\n// TASK 1.2: see TASK 1.1\nint b = 20;\n"
        "    //  TASK 1.1 again\n// TASK 1.10.\nint c = 30;";
    EXPECT_EQ(with_one_task(solution, submitted, "1.1"),
              "#include x\nint mine;\n// TASK 1.1 (2 points): a\nint a = 10;\n// TASK 1.2: see TASK 1.1\nint b = 2;\n"
              "// TASK 1.10: c\nint c = 3;\n");
    EXPECT_EQ(with_one_task(solution, submitted, "1.2"),
              "#include x\nint mine;\n// TASK 1.1 (2 points): a\nint a = 1;\n\n// TASK 1.2: see TASK 1.1\nint b = 20;\n"
              "    //  TASK 1.1 again\n// TASK 1.10: c\nint c = 3;\n");
    EXPECT_EQ(with_one_task(solution, submitted, "1.10"),
              "#include x\nint mine;\n// TASK 1.1 (2 points): a\nint a = 1;\n\n// TASK 1.2: see TASK 1.1\nint b = 2;\n"
              "// TASK 1.10.\nint c = 30;");
    EXPECT_EQ(with_one_task(solution, solution, "1.2"), solution);
}

// So a mistake in another task costs this task no points.
TEST(Transplant, TakesHelpersThatTheTaskUsesFromPartsOfOtherTasks) {
    const std::string submitted =
        "#include x\n// TASK 1.1: a\nfloat f(float);  // see \"g\"\n#define HALF(x) \\\n    (0.5 * (x))\nint a = 10;\n"
        "struct Pair { float a, b; };\nconst float scale[2] = float[2](1.0, 2.0);\nfloat broken() { return oops; }\n"
        "float f(float x) { /* } */ if (x > 0.0) { return HALF(x); } return scale[1]; }\nint unused = 3;\n"
        "// TASK 1.2: b\nint b = f(1.0) > g().a;\n// TASK 1.10: c\nint c = 30;\nPair g() { return Pair(1.0, 2.0); }\n";
    EXPECT_EQ(with_one_task(solution, submitted, "1.2"),
              "#include x\n// TASK 1.1 (2 points): a\nint a = 1;\n\nfloat f(float);\n"
              "#define HALF(x) \\\n    (0.5 * (x))\nstruct Pair { float a, b; };\n"
              "const float scale[2] = float[2](1.0, 2.0);\n"
              "float f(float x) { /* } */ if (x > 0.0) { return HALF(x); } return scale[1]; }\n"
              "// TASK 1.2: b\nint b = f(1.0) > g().a;\n// TASK 1.10: c\nint c = 3;\n"
              "Pair g() { return Pair(1.0, 2.0); }\n");
    EXPECT_EQ(with_one_task(solution, "// TASK 1.1\n#if X\nint f();\n#endif\n// TASK 1.2\nint b = f();\n", "1.2"),
              "// TASK 1.1 (2 points): a\nint a = 1;\n\n// TASK 1.2\nint b = f();\n// TASK 1.10: c\nint c = 3;\n")
        << "which of the two an #if leaves is not known";
}

TEST(Transplant, PutsCppHelpersInsideTheFilesNamespace) {
    const std::string two =
        "namespace relief {\n// TASK 2.1: a\nint a() { return 1; }\n// TASK 2.2: b\nint b() { return 2; }\n}  // end\n";
    EXPECT_EQ(with_one_task(two,
                            "namespace relief {\n// TASK 2.1: a\nint a() { return half(4); }\n// TASK 2.2: b\n"
                            "namespace {\ntemplate <class T>\nT half(T x) { return x / T{2}; }\n}\n"
                            "int b() { return half(5); }\n}  // end\n",
                            "2.1"),
              "namespace relief {\n// TASK 2.1: a\nint a() { return half(4); }\n// TASK 2.2: b\nint b() { return 2; }\n"
              "namespace {\ntemplate <class T>\nT half(T x) { return x / T{2}; }\n}\n}  // end\n");
}

TEST(Transplant, RequiresTheTaskLine) {
    EXPECT_FALSE(with_one_task(solution, "int a = 10;\n", "1.1"));
    EXPECT_FALSE(with_one_task(solution, "// TASK 1.10: c\n", "1.1"));
    EXPECT_FALSE(with_one_task(solution, "", "1.1"));
    EXPECT_FALSE(with_one_task(solution, "int TASK 1.1;\n", "1.1")) << "not a comment";
}

}  // namespace
}  // namespace relief::grade
