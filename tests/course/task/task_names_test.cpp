// Names near a task file's, and the marks of copies.
#include "framework/course/task/task_names.h"

#include <filesystem>

#include "tests/support.h"

namespace relief::check {
namespace {

namespace fs = std::filesystem;

const std::set<std::string> task_files = {"shaders/01_a/task.glsl", "shaders/12_relief_exact/task.glsl",
                                          "labs/05_b/task.cpp"};

TEST(TaskNames, OfTheHandoutAreNearNoTaskFile) {
    std::set<std::string> all;
    for (const char* folder : {"labs", "shaders"})
        for (const auto& entry : fs::recursive_directory_iterator(fs::path(source_folder) / folder))
            if (const std::string name = entry.path().filename().string(); name == "task.glsl" || name == "task.cpp")
                all.insert(entry.path().lexically_relative(source_folder).generic_string());
    ASSERT_GT(all.size(), 19u);
    for (const char* folder : {"framework", "labs", "shaders", "assets"})
        for (const auto& entry : fs::recursive_directory_iterator(fs::path(source_folder) / folder)) {
            const fs::path path = entry.path().lexically_relative(source_folder);
            const bool is_staffs = std::find(path.begin(), path.end(), "staff") != path.end();
            if (!entry.is_regular_file() || is_staffs) continue;
            EXPECT_FALSE(is_near_task_file("course/" + path.generic_string(), all)) << path;
        }
}

TEST(TaskNames, AreNearForCopiesAndOtherLetters) {
    for (const char* name :
         {"task (1).glsl", "a/Task.GLSL", "task.glsl.txt", "task-2.glsl", "task - Copy.glsl", "Copy of task.glsl",
          "task_final.cpp", "tasks.glsl", "lab12.glsl", "Lab 1.glsl", "12_relief_exact.glsl", "relief_exact.glsl",
          "task.glsl~", "jane_task.cpp", "a\\task.glsl"})
        EXPECT_TRUE(is_near_task_file(name, task_files)) << name;
    for (const char* name : {"task.frag", "surface.glsl", "lab2.glsl", "multitask.glsl", "tasking.glsl",
                             "task.glsl.new", "task", "../task.glsl", "/task.glsl", "a/../task.glsl", "._task.glsl", "",
                             "/", ".glsl", "label1.glsl", "shaders/01_a/task.glsl", "x/labs/05_b/task.cpp"})
        EXPECT_FALSE(is_near_task_file(name, task_files)) << name;
}

TEST(TaskNames, MeanTheLabOfTheTextThenOfThePath) {
    const auto meant = [](const char* name, const char* text) {
        return task_file_meant(name, text, task_files).value_or("none");
    };
    EXPECT_EQ(meant("task.glsl", "// TASK 12.1 (2 points)"), "shaders/12_relief_exact/task.glsl");
    EXPECT_EQ(meant("lab01.glsl", "// TASK 12.1"), "shaders/12_relief_exact/task.glsl") << "the text is the work";
    EXPECT_EQ(meant("lab01.glsl", "// TASK 12.1\n// see TASK 1.1"), "shaders/01_a/task.glsl") << "the text names two";
    EXPECT_EQ(meant("lab01.glsl", ""), "shaders/01_a/task.glsl");
    EXPECT_EQ(meant("Lab 12/task.glsl", ""), "shaders/12_relief_exact/task.glsl");
    EXPECT_EQ(meant("12_relief_exact/task (2).glsl", ""), "shaders/12_relief_exact/task.glsl");
    EXPECT_EQ(meant("task.cpp", ""), "labs/05_b/task.cpp") << "the only one in C++";
    EXPECT_EQ(meant("task.cpp", "// TASK 7.1"), "none") << "of a lab without such a file";
    EXPECT_EQ(meant("task.glsl", ""), "none");
    EXPECT_EQ(meant("task.glsl", "TASK 99999999999999.1 TASK .1 TASK 1."), "none");
}

TEST(TaskNames, ACopyHasItsNumber) {
    for (const auto& [name, original, number] :
         std::vector<std::tuple<std::string, std::string, int>>{{"jane", "jane", 0},
                                                                {"jane (2)", "jane", 2},
                                                                {"jane(12)", "jane", 12},
                                                                {"jane-3", "jane", 3},
                                                                {"jane - Copy", "jane", 1},
                                                                {"jane - Copy (2)", "jane", 2},
                                                                {"jane copy 3", "jane", 3},
                                                                {"jane_copy", "jane", 1},
                                                                {"(2)", "(2)", 0},
                                                                {"-2", "-2", 0},
                                                                {"", "", 0},
                                                                {"photocopy", "photocopy", 0},
                                                                {"copyright", "copyright", 0},
                                                                {"jane (99999999999)", "jane (99999999999)", 0},
                                                                {"jane (x)", "jane (x)", 0},
                                                                {"Zo\u00eb (1)", "Zo\u00eb", 1}}) {
        EXPECT_EQ(copy_name(name).original, original) << name;
        EXPECT_EQ(copy_name(name).number, number) << name;
    }
    EXPECT_EQ(copy_number("hand-in (1).zip/shaders/01_a/task.glsl"), 1);
    EXPECT_EQ(copy_number("a/task (3).glsl"), 3);
    EXPECT_EQ(copy_number("a/task.glsl"), 0);
}

}  // namespace
}  // namespace relief::check
