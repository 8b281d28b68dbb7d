// Marks in task files: the starters that a handout makes of them, and whether a task is unfinished.
#include "framework/course/task/starter.h"

#include "tests/support.h"

namespace relief::check {
namespace {

constexpr const char* task = R"(float two() {
    // TASK 9.1 (2 points): two.
    //[solution
    return 2.0;
    //]starter
    //| return unfinished(0.0);
    //]
}
// TASK 9.2 (1 point): unfinished() is a word here only.
float three() { return 3.0; }
)";

TEST(Starter, TakesThePlaceOfTheSolution) {
    EXPECT_EQ(starter_of(task, "t.glsl"), R"(float two() {
    // TASK 9.1 (2 points): two.
    return unfinished(0.0);
}
// TASK 9.2 (1 point): unfinished() is a word here only.
float three() { return 3.0; }
)");
}

TEST(Starter, LeavesATextWithoutMarksUnchanged) {
    for (const char* text : {"", "a", "a\n", "\n\n", "a\r\nb", "// [solution\n"})
        EXPECT_EQ(starter_of(text, "t"), text);
}

TEST(Starter, MayBeEmptyOrMissing) {
    EXPECT_EQ(starter_of("a\n//[solution\nb\n//]\nc\n", "t"), "a\nc\n");
    EXPECT_EQ(starter_of("a\n  //[solution\nb\n  //]starter\n  //|\n  //| x\n//]\nc\n", "t"), "a\n\n  x\nc\n");
}

TEST(Starter, ReportsUnpairedMarksWithTheirLine) {
    const auto message = [](const char* text) { return message_of([&] { starter_of(text, "t.glsl"); }); };
    EXPECT_TRUE(message("a\n//[solution\nb\n").starts_with("t.glsl:2: this //[solution is never closed"));
    EXPECT_TRUE(message("//]\n").starts_with("t.glsl:1: a //] without"));
    EXPECT_TRUE(message("a\n//]starter\n").starts_with("t.glsl:2: a //]starter without"));
    EXPECT_TRUE(message("//[solution\n//[solution\n").starts_with("t.glsl:2: a //[solution inside another"));
    EXPECT_TRUE(message("//[solution\n//]starter\nreturn 1;\n//]\n").starts_with("t.glsl:3: a line of a starter"));
}

TEST(Solution, IsTheTextBetweenTheMarks) {
    EXPECT_EQ(solution_lines(task, "t"), std::vector<std::string>{"return 2.0;"});
}

constexpr const char* with_regions = R"(int a;
    //(one
    int b;

      int c;
    //)
//(two
float two() {
    //[solution
    return 2.0;
    //]starter
    //| return 0.0;
    //]
}
//)
)";

TEST(Region, IsTheUnindentedTextBetweenItsMarks) {
    const Region one = region_of(with_regions, "t", "one"), two = region_of(with_regions, "t", "two");
    EXPECT_EQ(one.text, "int b;\n\n  int c;\n");
    EXPECT_FALSE(one.has_solution);
    EXPECT_EQ(two.text, "float two() {\n    return 2.0;\n}\n");
    EXPECT_TRUE(two.has_solution);
    EXPECT_EQ(message_of([] { region_of(with_regions, "t", "tow"); }),
              "t: unknown region 'tow': did you mean 'two'? There are: one, two");
    EXPECT_FALSE(message_of([] { region_of("int a;\n", "t", "one"); }).empty());
}

TEST(Region, IsNotHandedOut) {
    EXPECT_EQ(starter_of(with_regions, "t"), "int a;\n    int b;\n\n      int c;\nfloat two() {\n    return 0.0;\n}\n");
}

TEST(Region, ReportsUnpairedMarksWithTheirLine) {
    const auto message = [](const char* text) { return message_of([&] { starter_of(text, "t.glsl"); }); };
    EXPECT_TRUE(message("a\n//(x\nb\n").starts_with("t.glsl:2: this //( is never closed"));
    EXPECT_TRUE(message("//)\n").starts_with("t.glsl:1: a //) without"));
    EXPECT_TRUE(message("//(x\n//(y\n").starts_with("t.glsl:2: a //( inside another"));
    EXPECT_TRUE(message("//(\n").starts_with("t.glsl:1: a region has a name"));
    EXPECT_TRUE(message("//[solution\n//(x\n").starts_with("t.glsl:2: a region begins and ends outside"));
    EXPECT_TRUE(message("//(x\n//[solution\n//)\n").starts_with("t.glsl:3: a region begins and ends outside"));
}

TEST(TaskParts, ExtendFromATaskLineToTheNextTask) {
    const std::string text =
        "#include x\n// TASK 1.1 (2 points): a\nint a;\n    //  TASK 1.1 again\n// TASK 1.2.\nint b;";
    const std::vector<TaskPart> parts = task_parts(text);
    ASSERT_EQ(parts.size(), 3u);
    EXPECT_EQ(parts[0].text, "#include x\n");
    EXPECT_EQ(parts[1].task, "1.1");
    EXPECT_EQ(parts[1].text, "// TASK 1.1 (2 points): a\nint a;\n    //  TASK 1.1 again\n");
    EXPECT_EQ(parts[2].task, "1.2");
    EXPECT_EQ(parts[2].text, "// TASK 1.2.\nint b;");
}

}  // namespace
}  // namespace relief::check
