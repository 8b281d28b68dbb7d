#include "framework/staff/class/gradescope.h"

#include <fmt/format.h>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/text.h"
#include "framework/core/lab/registry.h"

namespace relief::grade {
namespace {

namespace fs = std::filesystem;

/// The parts of the course needed to build and to grade; without tests, slides and pages.
constexpr const char* course_parts[] = {"CMakeLists.txt", "LICENSE", "relief", "assets",
                                        "framework",      "labs",    "shaders"};

/// Writes an executable script that only its owner can read: one of the scripts contains the seed.
void write_script(const fs::path& file, const std::string& text) {
    write_private_file(file, text);
    fs::permissions(file, fs::perms::owner_all);
}

}  // namespace

void write_gradescope(const fs::path& folder, const std::vector<const LabEntry*>& labs, const std::string& seed) {
    const fs::path run = folder / "run_autograder", templates = course_root() / "framework/staff/class/gradescope";
    if (fs::exists(folder) && !fs::exists(run) && !(fs::is_directory(folder) && fs::is_empty(folder)))
        throw UsageError(fmt::format("'{}' has other files in it: name a new folder", folder.string()));
    make_folder(folder);
    const fs::path course = folder / "course";
    fs::remove_all(course);
    make_folder(course);
    try {
        for (const char* part : course_parts)
            fs::copy(course_root() / part, course / part, fs::copy_options::recursive);
    } catch (const fs::filesystem_error& error) {
        throw Error({course}, "cannot copy the course: " + error.code().message());
    }
    std::string lab_words;
    for (const LabEntry* lab : labs) lab_words += " --lab " + lab->two_digits();
    std::string text = read_file(templates / "run_autograder.in");
    for (const auto& [mark, words] :
         {std::pair<std::string, std::string>{"@SEED@", quoted_for_shell(seed)}, {"@LABS@", lab_words}})
        text.replace(text.find(mark), mark.size(), words);
    write_script(folder / "setup.sh", read_file(templates / "setup.sh"));
    write_script(run, text);
}

}  // namespace relief::grade
