// A copy of the course with the lab that `relief new-lab` makes, built: two labs to switch between.
#pragma once

#include "tests/app/course_copy.h"

namespace relief {

/// Made once for all tests of the program; what went wrong is in `failure`.
struct CourseWithNewLab {
    CourseCopy course;
    Result made;          ///< by `relief new-lab test_wall`
    std::string failure;  ///< of the build, or empty

    std::string program(const char* name) const { return course.path() / "bin" / name; }
    static const CourseWithNewLab& get();

private:
    CourseWithNewLab();
};

}  // namespace relief
