#include "framework/core/base/paths.h"

#include <optional>

#include "framework/core/base/error.h"
#include "framework/core/base/system.h"

namespace relief {
namespace {

namespace fs = std::filesystem;

bool is_course(const fs::path& folder) {
    std::error_code ignored;
    return fs::is_directory(folder / "labs", ignored) && fs::is_directory(folder / "shaders", ignored);
}

std::optional<fs::path> find_course() {
    for (fs::path folder = executable_folder();; folder = folder.parent_path()) {
        if (is_course(folder)) return folder;
        if (folder == folder.parent_path()) break;
    }
    if (is_course(RELIEF_SOURCE_FOLDER)) return RELIEF_SOURCE_FOLDER;
    return {};
}

std::optional<fs::path>& found_course() {
    static std::optional<fs::path> course = find_course();
    return course;
}

}  // namespace

const fs::path& executable_path() {
    static const fs::path path = os::executable();
    return path;
}

fs::path executable_folder() { return executable_path().parent_path(); }

const fs::path& course_root() {
    if (!found_course())
        throw Error("no folder above " + executable_folder().string() +
                    " holds the course (labs/ and shaders/): keep the executable inside the course's folder");
    return *found_course();
}

CourseElsewhere::CourseElsewhere(const fs::path& root) : before_(found_course()) {
    if (!is_course(root)) throw Error({root}, "is not a course: there is no labs/ or no shaders/ in it");
    found_course() = root;
}
CourseElsewhere::~CourseElsewhere() { found_course() = before_; }

std::string shown(const fs::path& path) {
    if (path.is_absolute() && found_course()) {
        const fs::path inside = path.lexically_relative(*found_course());
        if (!inside.empty() && *inside.begin() != "..") return inside.string();
    }
    return path.string();
}

}  // namespace relief
