#include "tests/course/app/course_with_new_lab.h"

namespace relief {

const CourseWithNewLab& CourseWithNewLab::get() {
    static const CourseWithNewLab course;
    return course;
}

CourseWithNewLab::CourseWithNewLab() : made(course.relief({"new-lab", "test_wall"})) {
    for (const std::string& lab : files_in(course.path() / "labs"))
        if (lab != "01_specular_highlights" && lab != "20_test_wall" &&
            std::filesystem::is_directory(course.path() / "labs" / lab))
            std::filesystem::remove_all(course.path() / "labs" / lab);
    const std::string build = course.path() / "build";
    const std::vector<std::string> commands[] = {
        {"cmake", "-S", std::string(source_folder) + "/tests/new_lab", "-B", build, "-G", "Ninja",
         "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_COMPILE_WARNING_AS_ERROR=ON", "-DCOURSE=" + course.path().string(),
         "-DRELIEF_BUILD=" + std::string(build_folder)},
        {"cmake", "--build", build}};
    for (const auto& command : commands) {
        const Result result = run(command);
        if (result.code != 0) failure += result.out + result.err;
        if (!failure.empty()) return;
    }
}

}  // namespace relief
