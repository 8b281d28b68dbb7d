// One task of a submission among the solutions of the others.
#include "framework/staff/grade/transplant.h"

#include <gtest/gtest.h>

namespace relief {
namespace {

const std::string solution =
    "#include x\n// TASK 1.1 (2 points): a\nint a = 1;\n\n// TASK 1.2: see TASK 1.1\nint b = 2;\n// TASK 1.10: c\nint "
    "c = 3;\n";

TEST(Transplant, TakesOneTaskAndWhatStandsBeforeAll) {
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

TEST(Transplant, NeedsTheTasksLine) {
    EXPECT_FALSE(with_one_task(solution, "int a = 10;\n", "1.1"));
    EXPECT_FALSE(with_one_task(solution, "// TASK 1.10: c\n", "1.1"));
    EXPECT_FALSE(with_one_task(solution, "", "1.1"));
    EXPECT_FALSE(with_one_task(solution, "int TASK 1.1;\n", "1.1")) << "not a comment";
}

}  // namespace
}  // namespace relief
