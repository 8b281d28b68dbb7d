// `relief handout` for a course with broken labs: it must not hand out a lab that nobody can solve.
#include "tests/course/app/course_copy.h"

namespace relief::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* task = "shaders/01_specular_highlights/task.glsl";

TEST(HandoutCommand, RefusesALabWhoseOwnSolutionDoesNotPass) {
    const CourseCopy course;
    fs::create_directories(course.path() / "framework/staff/handout");
    for (const char* name : {"framework/staff/handout/handout_readme.md", "framework/staff/handout/handout_check.yml"})
        fs::copy_file(fs::path(source_folder) / name, course.path() / name);
    const std::string whole = read_all(course.path() / task);
    const fs::path students = course.path() / "students";
    const auto hand_out = [&](const std::string& labs) {
        return course.relief({"handout", "-o", students.string(), "--labs", labs});
    };
    const size_t begin = whole.find("return ", whole.find("//[solution"));
    for (const auto& [code, said] : {std::pair("return vec3(0.6, 0.0, 0.8); ",
                                               "lab 01 cannot be handed out: its own "
                                               "solution does not pass '"),
                                     std::pair("retrun ", "lab 01 cannot be handed out: ")}) {
        course.overwrite(task, std::string(whole).insert(begin, code));
        const Result refused = hand_out("1");
        EXPECT_EQ(refused.code, 1) << code;
        EXPECT_TRUE(contains(refused.err, said)) << refused.err;
        EXPECT_FALSE(fs::exists(students));
    }
    EXPECT_EQ(hand_out("3").code, 0) << "the others can be";
}

}  // namespace
}  // namespace relief::app
