#include "framework/staff/grade/overlay.h"

#include <fmt/format.h>
#include <unistd.h>

#include <set>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"

namespace relief::grade {

namespace fs = std::filesystem;

CourseFiles edited(const std::vector<Edit>& edits) {
    CourseFiles files;
    for (const Edit& edit : edits) {
        const fs::path path = course_root() / edit.file;
        if (!files.contains(edit.file)) files[edit.file] = read_file(path);
        std::string& text = files[edit.file];
        const size_t at = text.find(edit.find);
        if (edit.find.empty() || at == std::string::npos || text.find(edit.find, at + 1) != std::string::npos)
            throw Error({path}, fmt::format("'{}' must occur exactly once", edit.find));
        text.replace(at, edit.find.size(), edit.replace);
    }
    return files;
}

CourseOverlay::Folder::Folder() {
    std::string name = (fs::temp_directory_path() / "relief-course-XXXXXX").string();
    if (!mkdtemp(name.data())) throw Error({name}, "cannot make this folder");
    path = name;
}
CourseOverlay::Folder::~Folder() {
    std::error_code ignored;  // harmless: the folder is in the system's temporary folder
    fs::remove_all(path, ignored);
}

const CourseOverlay::Folder& CourseOverlay::fill(const Folder& folder, const CourseFiles& files) {
    std::set<fs::path> own;  // folders with one of the files, which cannot be links
    for (const auto& [name, text] : files)
        for (fs::path parent = fs::path(name).parent_path(); !parent.empty(); parent = parent.parent_path())
            own.insert(parent);
    const auto link_rest = [&](const fs::path& part) {
        make_folder(folder.path / part);
        if (!fs::is_directory(course_root() / part)) return;  // a folder that only `files` has
        for (const auto& entry : fs::directory_iterator(course_root() / part)) {
            const fs::path name = part / entry.path().filename();
            if (!own.contains(name) && !files.contains(name.string()))
                fs::create_symlink(entry.path(), folder.path / name);
        }
    };
    link_rest({});
    for (const fs::path& part : own) link_rest(part);
    for (const auto& [name, text] : files) write_file(folder.path / name, text);
    return folder;
}

CourseOverlay::CourseOverlay(const CourseFiles& files) : elsewhere_(fill(folder_, files).path) {}

}  // namespace relief::grade
