// A copy of the course in which some files are replaced.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "framework/core/base/paths.h"
#include "framework/course/manifest/manifest.h"

namespace relief::grade {

/// The texts of files, by path relative to the course's top folder.
using CourseFiles = std::map<std::string, std::string>;

/// Returns the edited files, with all edits made. Throws Error if an edit's `find` does not occur exactly once.
CourseFiles edited(const std::vector<Edit>& edits);

/// Redirects course_root() for its lifetime, to a temporary folder with these files and links to all other files.
class CourseOverlay {
public:
    explicit CourseOverlay(const CourseFiles& files);
    const std::filesystem::path& root() const { return folder_.path; }

private:
    struct Folder {
        Folder();
        ~Folder();
        std::filesystem::path path;
    };
    static const Folder& fill(const Folder& folder, const CourseFiles& files);

    Folder folder_;
    CourseElsewhere elsewhere_;
};

}  // namespace relief::grade
