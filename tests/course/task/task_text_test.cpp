// A task file by its functions.
#include "framework/course/task/task_text.h"

#include "tests/support.h"

namespace relief::check {
namespace {

const std::string small_file = "shaders/x/task.glsl";

std::vector<TaskInfo> small_tasks() {
    return {{.id = "1.1", .title = "", .file = small_file, .functions = {"gap(float, float)", "march(float)"}},
            {.id = "1.2", .title = "", .file = small_file, .functions = {"crossing(float, float)"}}};
}

const std::string small_text =
    "const float tiny = 0.1;\nfloat half_of(float x) { return 0.5 * x; }\nfloat gap(float a, float b) {\n"
    "    return a - b;\n}\nfloat march(float a) {\n    return unfinished(0.0);\n}\n"
    "float crossing(float a, float b) {\n    return half_of(a) + tiny;  // unfinished(0.0)\n}\nint nobodys;\n";

TEST(TaskText, FindsATaskByItsFunctionsAndNamesTheMissingOnes) {
    EXPECT_TRUE(missing_functions(small_text, small_tasks()[0]).empty());
    EXPECT_EQ(missing_text("float gap(float a, float b) { return 1.0; }", small_tasks()[0]),
              small_file + " has no function `march(float)`, which task 1.1 asks for: keep the names and signatures");
    EXPECT_EQ(missing_functions("float crossing(float a) { return a; }", small_tasks()[1]),
              std::vector<std::string>{"crossing(float, float)"});
    EXPECT_EQ(missing_functions("float crossing(float a, float b);", small_tasks()[1]).size(), 1u) << "a prototype";
    EXPECT_EQ(
        missing_functions("#if 0\nfloat crossing(float a, float b) { return a; }\n#endif\n", small_tasks()[1]).size(),
        1u);
    EXPECT_TRUE(missing_text(small_text, small_tasks()[1]).empty());
}

TEST(TaskText, IsUnfinishedWhileAFunctionOfTheTaskCallsUnfinished) {
    EXPECT_TRUE(is_unfinished(small_text, small_tasks()[0]));
    EXPECT_FALSE(is_unfinished(small_text, small_tasks()[1])) << "a word in a comment is no call";
    EXPECT_FALSE(is_unfinished("float crossing(float a, float b) { return is_unfinished(a); }", small_tasks()[1]));
    const TaskInfo whole{.id = "1.3", .title = "", .file = small_file};
    EXPECT_TRUE(is_unfinished("/* */ unfinished (0.0);", whole)) << "without functions, the file is the task";
}

TEST(TaskText, IsWrittenIfTheCallOfUnfinishedIsNeverReached) {
    const TaskInfo own{.id = "1.1", .title = "", .file = small_file, .functions = {"f(float)", "g(float)"}};
    const auto is_open = [&](const std::string& body) {
        return is_unfinished("float f(float x) {\n" + body + "\n}\n", own);
    };
    EXPECT_FALSE(is_open("return 2.0 * x;\nreturn unfinished(0.0);"));
    EXPECT_FALSE(is_open("if (x > 0.0) { return x; }\nreturn unfinished(0.0);")) << "what runs is judged";
    EXPECT_FALSE(is_open("#if 0\nreturn unfinished(0.0);\n#endif\nreturn x;"));
    EXPECT_FALSE(
        is_open("# if 0 // the starter\n# if 1\n# endif\nreturn unfinished(0.0);\n# else\nreturn x;\n# endif"));
    EXPECT_TRUE(is_open("#if 1\nreturn unfinished(0.0);\n#endif"));
    EXPECT_TRUE(is_open("#if 0\nreturn x;\n#else\nreturn unfinished(0.0);\n#endif"));
    EXPECT_TRUE(is_open("float returned = x; // return x;\nreturn\n    unfinished(returned);"));
    EXPECT_TRUE(is_open("return x;\n}\nfloat g(float x) { if (x > 0.0) { x = 1.0; }\n return unfinished(0.0);"))
        << "another function of the task";
    const std::string cpp =
        "namespace relief {\nint f(float x) {\n    return x;\n    unfinished(\"1.1\");\n}\n"
        "int crossing(float, float) {\n    unfinished(\"1.2\");\n}\n}\n";
    EXPECT_FALSE(is_unfinished(cpp, own));
    EXPECT_TRUE(is_unfinished(cpp, small_tasks()[1]));
    EXPECT_EQ(line_of_unfinished(cpp, own), 4);
    EXPECT_EQ(line_of_unfinished(cpp, small_tasks()[1]), 7);
    EXPECT_EQ(line_of_unfinished("#if 0\nfloat f(float x) { unfinished(1.0); }\n#endif\n", own), 0);
}

TEST(TaskText, ALineBelongsToTheTaskOfItsFunctionOrToOneThatUsesIt) {
    const auto at = [](size_t line) { return task_at_line(small_text, small_tasks(), small_file, line); };
    EXPECT_EQ(at(1), "1.2") << "a constant that only 1.2 uses";
    EXPECT_EQ(at(2), "1.2");
    EXPECT_EQ(at(3), "1.1");
    EXPECT_EQ(at(5), "1.1");
    EXPECT_EQ(at(6), "1.1");
    EXPECT_EQ(at(10), "1.2");
    EXPECT_EQ(at(12), "") << "nobody's";
    EXPECT_EQ(at(0), "");
    EXPECT_EQ(at(99), "");
    EXPECT_EQ(task_at_line("", small_tasks(), small_file, 1), "");
    EXPECT_EQ(line_of_task(small_text, small_tasks()[1]), 9);
    EXPECT_EQ(line_of_task("", small_tasks()[1]), 0);
}

}  // namespace
}  // namespace relief::check
