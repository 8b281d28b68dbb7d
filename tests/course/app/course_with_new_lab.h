// A copy of the course with the built lab of `relief new-lab`: two labs to switch between.
#pragma once

#include "tests/course/app/course_copy.h"

namespace relief {

/// Made once for all tests of the program. `failure` holds the errors.
struct CourseWithNewLab {
    CourseCopy course;
    Result made;          ///< result of `relief new-lab test_wall`
    std::string failure;  ///< output of a failed build, or empty

    std::string program(const char* name) const { return course.path() / "bin" / name; }
    static const CourseWithNewLab& get();

private:
    CourseWithNewLab();
};

}  // namespace relief
