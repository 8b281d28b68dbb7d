// The staff's part of relief explain: replaces the course's task files by known mistakes or submissions.
#include "framework/course/app/explain.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "framework/core/base/error.h"
#include "framework/staff/grade/overlay.h"
#include "framework/staff/grade/stage.h"
#include "framework/staff/grade/submission.h"

namespace relief::app {
namespace {

grade::CourseFiles submitted(const Manifest& manifest, const std::string& path) {
    std::set<std::string> wanted = grade::task_files(manifest);
    std::erase_if(wanted, [](const std::string& file) { return !is_shader(file); });
    const grade::Submission submission = grade::read_submission(path, wanted);
    if (!submission.problem.empty()) throw Error({path}, submission.problem);
    if (submission.files.empty()) throw Error({path}, fmt::format("has no {}", fmt::join(wanted, " and no ")));
    return submission.files;
}

std::shared_ptr<void> with_files(const Manifest& manifest, const std::string& mistake, const std::string& submission) {
    const grade::CourseFiles files =
        mistake.empty() ? submitted(manifest, submission) : grade::edited(manifest.mistake(mistake).edits);
    for (const auto& [name, text] : files)
        if (!mistake.empty() && name.ends_with(".cpp"))
            throw UsageError(fmt::format("'{}' is a mistake in C++: only shaders are explained", mistake));
    return std::make_shared<grade::CourseOverlay>(files);
}

const FromStaff<std::shared_ptr<void>(const Manifest&, const std::string&, const std::string&)>::Provided provided(
    course_with, with_files);

}  // namespace
}  // namespace relief::app
