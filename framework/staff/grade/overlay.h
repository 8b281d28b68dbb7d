// A course that is another one but for some files.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "framework/base/paths.h"
#include "framework/lab/manifest.h"

namespace relief {

/// Paths relative to the course's top folder, and what stands there.
using CourseFiles = std::map<std::string, std::string>;

/// The files that edits make of those of the course. Throws Error where `find` does not stand exactly once.
CourseFiles edited(const std::vector<Edit>& edits);

/// While this is alive, course_root() is a temporary folder with these files in it and links to all the others.
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

}  // namespace relief
