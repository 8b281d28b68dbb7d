// Where the course is on disk. It is found from the executable's path, never from the working directory.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace relief {

/// The running executable and its folder, links resolved.
const std::filesystem::path& executable_path();
std::filesystem::path executable_folder();

/// The course's top folder: the nearest one above the executable that has `labs` and `shaders` in it, else
/// the source folder that this was built from. Throws Error when neither is there.
const std::filesystem::path& course_root();

/// While this is alive, course_root() is another folder with `labs` and `shaders`: a course with a student's files in
/// it; there need be no other. One at a time, and on the thread that reads the course.
class CourseElsewhere {
public:
    explicit CourseElsewhere(const std::filesystem::path& root);
    ~CourseElsewhere();
    CourseElsewhere(const CourseElsewhere&) = delete;
    CourseElsewhere& operator=(const CourseElsewhere&) = delete;

private:
    std::optional<std::filesystem::path> before_;
};

/// A path as shown to a person: relative to the course's top folder if inside it, else unchanged.
std::string shown(const std::filesystem::path& path);

}  // namespace relief
