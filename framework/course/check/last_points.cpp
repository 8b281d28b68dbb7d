#include "framework/course/check/last_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"

namespace relief::check {
namespace {

namespace fs = std::filesystem;

fs::path file_of(const LabEntry& lab) { return course_root() / "build" / "check" / (lab.folder + ".points"); }

}  // namespace

fs::file_time_type last_saved(const Manifest& manifest) {
    fs::file_time_type last = fs::file_time_type::min();
    for (const TaskInfo& task : manifest.tasks) {
        std::error_code missing;
        const fs::file_time_type saved = fs::last_write_time(course_root() / task.file, missing);
        if (!missing) last = std::max(last, saved);
    }
    return last;
}

void keep_points(const LabEntry& lab, const std::vector<TaskVerdict>& tasks, fs::file_time_type saved) {
    const PointSum sum = sum_of(tasks), optional = sum_of(tasks, true);
    std::string text = points_text(sum.points);
    if (optional.of > 0) text += " + " + points_text(optional.points);
    try {
        make_folder(file_of(lab).parent_path());
        write_file(file_of(lab), text);
        // The time of the checked files, not of this one: no second clock, and no gap in which a file is saved unseen.
        std::error_code refused;
        fs::last_write_time(file_of(lab), saved, refused);
        if (refused) fs::remove(file_of(lab), refused);
    } catch (const Error&) {
        // A course that one may only read has no memory of its checks.
    }
}

std::optional<std::string> last_points(const LabEntry& lab, const Manifest& manifest) {
    std::error_code none;
    const fs::file_time_type kept = fs::last_write_time(file_of(lab), none);
    if (none) return {};
    const bool is_newer = std::any_of(manifest.tasks.begin(), manifest.tasks.end(), [&](const TaskInfo& task) {
        const fs::file_time_type changed = fs::last_write_time(course_root() / task.file, none);
        return none || changed > kept;
    });
    if (is_newer) return {};
    try {
        return read_file(file_of(lab), 100);
    } catch (const Error&) {
        return {};
    }
}

}  // namespace relief::check
