#include "framework/staff/class/progress.h"

#include <fmt/format.h>

#include <algorithm>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/parallel.h"
#include "framework/core/base/text.h"
#include "framework/staff/class/merge.h"
#include "framework/staff/grade/strangers_text.h"

namespace relief::grade {

namespace fs = std::filesystem;

fs::path result_file(const fs::path& folder, const std::string& name) {
    return folder / "results" / (file_name_of(name) + ".json");
}

std::optional<SubmissionMark> result_of(const fs::path& folder, const std::string& name, const std::string& course) {
    const fs::path file = result_file(folder, name);
    if (!fs::exists(file)) return {};
    try {
        SubmissionMark mark = from_json(read_file(file, size_t{1} << 26));
        if (mark.name == name && mark.course == course && mark.graded()) return mark;
    } catch (const Error&) {  // an incomplete file, or one of another version
    }
    return {};
}

size_t ClassProgress::results() const {
    return size_t(std::count_if(marks.begin(), marks.end(), [](const auto& mark) { return mark.has_value(); }));
}

std::vector<std::string> ClassProgress::without_result() const {
    std::vector<std::string> names;
    for (size_t i = 0; i < marks.size(); ++i)
        if (!marks[i]) names.push_back(roster.submissions[i].name);
    return names;
}

ClassProgress read_progress(const fs::path& folder) {
    const std::vector<fs::path> parts = class_parts(folder);
    ClassProgress progress{.roster = read_roster(parts.front()).value(), .marks = {}};
    progress.marks.resize(progress.roster.submissions.size());
    parallel_each(progress.marks.size(), 0, [&](size_t i) {
        for (const fs::path& part : parts)
            if (!progress.marks[i])
                progress.marks[i] = result_of(part, progress.roster.submissions[i].name, progress.roster.course);
    });
    return progress;
}

std::string some_of(const std::vector<std::string>& names) {
    constexpr size_t shown = 5;
    std::vector<std::string> first;
    for (const std::string& name : names)
        if (first.size() < shown) first.push_back(printable(name));
    return join(first, ", ") + (names.size() > shown ? fmt::format(" and {} more", names.size() - shown) : "");
}

}  // namespace relief::grade
