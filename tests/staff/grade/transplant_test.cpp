// One task of a submission among the solutions of all other tasks.
#include "framework/staff/grade/transplant.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace relief::grade {
namespace {

const std::string tiny_file = "shaders/x/task.glsl";

std::vector<TaskInfo> tiny_tasks() {
    return {{.id = "1.1", .title = "", .file = tiny_file, .functions = {"a(float)"}},
            {.id = "1.2", .title = "", .file = tiny_file, .functions = {"b(float)"}},
            {.id = "1.10", .title = "", .file = tiny_file, .functions = {"c(float)", "d(float)"}}};
}

std::optional<std::string> with_tiny_task(const std::string& solution, const std::string& submitted, size_t task) {
    return with_one_task(solution, submitted, tiny_tasks(), tiny_tasks()[task]);
}

const std::string solution =
    "#include x\nconst float one = 1.0;\n\n// TASK 1.1 (2 points): a\nfloat a(float x) { return one; }\n// TASK 1.2: "
    "b\n"
    "float b(float x) { return a(x); }\n// TASK 1.10: c, d\nfloat c(float x) { return b(x); }\nfloat d(float x) { "
    "return "
    "c(x); }\n";

TEST(Transplant, ReplacesTheFunctionsOfAllOtherTasks) {
    const std::string mine =
        "#include x\nconst float one = 1.0;\nfloat a(float y) { return 10.0; }\nfloat b(float y) { return 20.0; }\n"
        "float c(float y) { return 30.0; } // C\nfloat d(float y) { return 40.0; }\n";
    EXPECT_EQ(
        with_tiny_task(solution, mine, 0),
        "#include x\nconst float one = 1.0;\nfloat a(float y) { return 10.0; }\nfloat b(float x) { return a(x); }\n"
        "float c(float x) { return b(x); } // C\nfloat d(float x) { return c(x); }\n");
    EXPECT_EQ(
        with_tiny_task(solution, mine, 2),
        "#include x\nconst float one = 1.0;\nfloat a(float x) { return one; }\nfloat b(float x) { return a(x); }\n"
        "float c(float y) { return 30.0; } // C\nfloat d(float y) { return 40.0; }\n");
    EXPECT_EQ(with_tiny_task(solution, solution, 1), solution);
}

TEST(Transplant, KeepsWhatTheTaskUsesAndDropsOtherHelpers) {
    EXPECT_EQ(
        with_tiny_task(
            solution,
            "#define HALF(x) (0.5 * (x))\nconst float one = 2.0;\nfloat half_of(float x) { return HALF(x); }\n"
            "float wrong(float x) { return nothing; }\nfloat a(float x) { return wrong(x); }\n"
            "float b(float x) { return half_of(x); }\nfloat c(float x) { return x; }\nfloat d(float x) { return x; }\n",
            1),
        "#define HALF(x) (0.5 * (x))\nconst float one = 1.0;\nfloat half_of(float x) { return HALF(x); }\n"
        "float a(float x) { return one; }\nfloat b(float x) { return half_of(x); }\n"
        "float c(float x) { return b(x); }\nfloat d(float x) { return c(x); }\n")
        << "the constant `one` is the solution's, because only the other tasks use it";
}

TEST(Transplant, FunctionsStandInAnyOrderAndThoseThatLackAreAdded) {
    EXPECT_EQ(
        with_tiny_task(solution, "float b(float y) { return a(y); }\n", 1),
        "const float one = 1.0;\nfloat a(float x) ;\nfloat b(float y) { return a(y); }\nfloat a(float x) { return one; "
        "}\n\nfloat c(float x) { return b(x); }\n\nfloat d(float x) { return c(x); }\n\n");
    EXPECT_EQ(
        with_tiny_task(solution,
                       "float a(float);\nfloat d(float x) { return c(x); }\nfloat c(float x) { return 3.0; }\n"
                       "float b(float x) { return 2.0; }\nconst float one = 5.0;\nfloat a(float x) { return 1.0; }\n",
                       2),
        "float a(float);\nfloat c(float x) ;\nfloat d(float x) { return c(x); }\nfloat c(float x) { return 3.0; }\n"
        "float b(float x) { return a(x); }\nconst float one = 1.0;\nfloat a(float x) { return one; }\n");
}

TEST(Transplant, ABracketTooManyOrTooFewCostsOnlyItsOwnTask) {
    for (const char* broken :
         {"float a(float x) { if (x > 0.0) { return 1.0; }\n", "float a(float x) { x = 1.0; }\n return x; }\n"}) {
        const std::string mine = std::string("const float one = 1.0;\n") + broken +
                                 "float b(float y) { return 2.0; }\nfloat c(float y) { return y; }\nfloat d(float y) { "
                                 "return y; }\n";
        const std::string text = with_tiny_task(solution, mine, 1).value_or("");
        EXPECT_NE(text.find("float a(float x) { return one; }"), std::string::npos) << text;
        EXPECT_NE(text.find("float b(float y) { return 2.0; }"), std::string::npos) << text;
        EXPECT_EQ(std::count(text.begin(), text.end(), '{'), 4) << text;
        EXPECT_EQ(std::count(text.begin(), text.end(), '}'), 4) << text;
        EXPECT_EQ(text.find("return x; }"), std::string::npos) << text;
    }
}

TEST(Transplant, KeepsConditionsAndNamespaces) {
    const std::string two =
        "namespace relief {\n#ifdef A\nfloat a(float x) { return 1; }\n#else\nfloat b(float x) { return 2; }\n#endif\n"
        "float c(float x) { return 3; }\nfloat d(float x) { return 4; }\n}  // end\n";
    std::string mine = two;
    mine.replace(mine.find("return 2"), 8, "return 20");
    EXPECT_EQ(with_tiny_task(two, mine, 1), mine);
    EXPECT_EQ(with_tiny_task(two, mine, 0), two);
}

// So the two halves of a program have each function once.
TEST(Transplant, WithoutASolutionOnlyTheTaskIsLeft) {
    const std::string mine =
        "#include x\nfloat half_of(float x) { return x / 2; }\nfloat other(float x) { return x; }\n"
        "float a(float x) { return other(x); }\nfloat b(float x) { return half_of(a(x)); }\n"
        "float c(float x) { return x; }\nfloat d(float x) { return x; }\n";
    const std::vector<TaskInfo> tasks = tiny_tasks();
    EXPECT_EQ(with_one_task("", mine, tasks, tasks[1]),
              "#include x\nfloat half_of(float x) { return x / 2; }\n"
              "float b(float x) { return half_of(a(x)); }\n");
    EXPECT_EQ(without_task(solution, tasks, tasks[2]), solution.substr(0, solution.find("float c(")) + "\n\n");
    EXPECT_EQ(without_task(solution, tasks, tasks[0]).find("float a("), std::string::npos);
}

TEST(Transplant, NothingWithoutTheTasksFunctions) {
    EXPECT_FALSE(with_tiny_task(solution, "float b(float x) { return x; }\n", 0));
    EXPECT_FALSE(with_tiny_task(solution, "float c(float x) { return x; }\n", 2)) << "one of two";
    EXPECT_FALSE(with_tiny_task(solution, "", 0));
    EXPECT_FALSE(with_tiny_task(solution, "// float a(float x) { return x; }\n", 0)) << "a comment";
}

}  // namespace
}  // namespace relief::grade
