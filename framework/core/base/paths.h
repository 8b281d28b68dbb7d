// The course's place on disk. It is found from the executable's path, never from the working directory.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace relief {

/// Return the running executable and its folder, with symbolic links resolved.
const std::filesystem::path& executable_path();
std::filesystem::path executable_folder();

/// Returns the course's top folder: the nearest folder above the executable that contains `labs` and `shaders`, else
/// the source folder of the build. Throws Error when neither exists.
const std::filesystem::path& course_root();

/// While this object exists, course_root() returns another folder with `labs` and `shaders`: a course with a student's
/// files. The program need not be in a course itself. Allows one object at a time, on the thread that reads the course.
/// The constructor throws Error when the folder is not a course.
class CourseElsewhere {
public:
    explicit CourseElsewhere(const std::filesystem::path& root);
    ~CourseElsewhere();
    CourseElsewhere(const CourseElsewhere&) = delete;
    CourseElsewhere& operator=(const CourseElsewhere&) = delete;

private:
    std::optional<std::filesystem::path> before_;
};

/// Returns a path for people: relative to the course's top folder if inside it, else unchanged.
std::string shown(const std::filesystem::path& path);

}  // namespace relief
