#include "framework/course/manifest/paths.h"

#include <fmt/format.h>

#include <algorithm>

#include "framework/core/base/error.h"
#include "framework/core/base/text.h"

namespace relief {
namespace {

/// "a", "a and b", "a, b and c". Precondition: there is one.
std::string listed(std::vector<std::string> words) {
    const std::string last = words.back();
    words.pop_back();
    return words.empty() ? last : join(words, ", ") + " and " + last;
}

/// "task 2.5", "tasks 14.5 and 14.6", or an empty text
template <class Wanted>
std::string tasks_text(const Manifest& manifest, Wanted is_wanted) {
    std::vector<std::string> ids;
    for (const TaskInfo& task : manifest.tasks)
        if (is_wanted(task)) ids.push_back(task.id);
    return ids.empty() ? "" : (ids.size() == 1 ? "task " : "tasks ") + listed(ids);
}

/// "lab 04", "labs 04 and 05", or an empty text
std::string labs_text(const std::vector<std::string>& labs) {
    return labs.empty() ? "" : (labs.size() == 1 ? "lab " : "labs ") + listed(labs);
}

/// Joins the parts that are not empty.
std::string joined(const std::vector<std::string>& parts, const char* between) {
    std::vector<std::string> some;
    for (const std::string& part : parts)
        if (!part.empty()) some.push_back(part);
    return join(some, between);
}

}  // namespace

const CoursePath& find_path(const std::string& wanted) {
    std::vector<std::string> names;
    for (const CoursePath& path : course_paths) {
        if (wanted == path.name) return path;
        names.emplace_back(path.name);
    }
    names.emplace_back("all");  // of `relief list`: every lab
    throw UsageError(unknown("path", wanted, names));
}

std::vector<CourseWeek> weeks_of(const CoursePath& path, const std::vector<const Manifest*>& labs) {
    std::vector<CourseWeek> weeks(size_t(path.weeks));
    for (size_t i = 0; i < labs.size(); ++i)
        if (const auto found = labs[i]->weeks.find(path.name); found != labs[i]->weeks.end()) {
            CourseWeek& week = weeks[size_t(found->second - 1)];
            week.labs.push_back(i);
            week.hours += labs[i]->hours;
        }
    return weeks;
}

std::string points_of_lab(const Manifest& manifest) {
    const int optional = manifest.optional_points();
    return fmt::format("{} points{}", manifest.points(), optional > 0 ? fmt::format(" and {} optional", optional) : "");
}

std::string hours_text(double hours) { return fmt::format("{} {}", hours, hours == 1 ? "hour" : "hours"); }

std::string effort_text(const Manifest& manifest) {
    const auto is_cpp = [](const TaskInfo& task) { return !is_shader(task.file); };
    const auto cpp = size_t(std::count_if(manifest.tasks.begin(), manifest.tasks.end(), is_cpp));
    const std::string before = joined({labs_text(manifest.needs), join(manifest.mathematics, ", ")}, "; ");
    std::vector<std::string> chapters;
    for (const std::string& chapter : manifest.leave_out) chapters.push_back("the chapter “" + chapter + "”");
    const std::string less = joined(
        {tasks_text(manifest, [](const TaskInfo& task) { return task.optional; }), join(chapters, " and ")}, ", and ");
    return fmt::format(
        "About {}. {}{} {}{}", hours_text(manifest.hours), before.empty() ? "" : "Before it: " + before + ". ",
        cpp == 0                       ? "No C++."
        : cpp == manifest.tasks.size() ? "All tasks are in C++."
                                       : "C++ in " + tasks_text(manifest, is_cpp) + ".",
        manifest.elective ? "An elective: no other lab needs it."
        : less.empty()    ? "Leave nothing out."
                          : "",
        less.empty() ? "" : (manifest.elective ? " You may leave out " : "You may leave out ") + less + ".");
}

}  // namespace relief
