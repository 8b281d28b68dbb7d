#include "framework/staff/class/merge.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/text.h"
#include "framework/staff/class/progress.h"
#include "framework/staff/grade/strangers_text.h"

namespace relief::grade {
namespace {

namespace fs = std::filesystem;
using Results = std::map<std::string, std::vector<SubmissionMark>>;  // by the submission's name

SubmissionMark read_result(const fs::path& file) {
    try {
        return from_json(read_file(file, size_t{1} << 26));
    } catch (const Error& error) {
        throw Error({file}, fmt::format("{}: remove it, and run the grading of its part again, which repeats no other",
                                        error.what()));
    }
}

/// Throws Error if a mark has a task, or points for a task, that this course does not have.
void refuse_other_points(const SubmissionMark& mark, const std::map<std::string, Manifest>& manifests,
                         const fs::path& file) {
    for (const LabMark& lab : mark.labs) {
        const auto manifest = manifests.find(lab.lab);
        for (const check::TaskVerdict& task : lab.tasks) {
            const bool is_known =
                manifest != manifests.end() && std::any_of(manifest->second.tasks.begin(), manifest->second.tasks.end(),
                                                           [&](const TaskInfo& info) { return info.id == task.id; });
            if (!is_known || manifest->second.task(task.id).points != task.of)
                throw Error({file}, fmt::format("has a task {} of {} points, which this course does not have",
                                                printable(task.id), task.of));
        }
    }
}

void refuse_another_class(const Roster& roster, const fs::path& part, const Roster& first, const fs::path& first_part) {
    const std::string first_file = (first_part / "class.json").string();
    if (roster.course != first.course || roster.seed != first.seed || roster.labs != first.labs)
        throw Error({part / "class.json"}, "belongs to another course, seed or choice of labs than " + first_file);
    const auto same = [](const Roster::One& a, const Roster::One& b) { return a.name == b.name && a.hash == b.hash; };
    if (!std::equal(roster.submissions.begin(), roster.submissions.end(), first.submissions.begin(),
                    first.submissions.end(), same))
        throw Error({part / "class.json"}, "names other submissions than " + first_file);
}

void read_results(const fs::path& part, const std::map<std::string, Manifest>& manifests, Results& results) {
    if (!fs::is_directory(part / "results")) return;
    for (const auto& entry : fs::directory_iterator(part / "results")) {
        if (entry.path().extension() != ".json") continue;
        SubmissionMark mark = read_result(entry.path());
        refuse_other_points(mark, manifests, entry.path());
        results[mark.name].push_back(std::move(mark));
    }
}

/// Throws Error unless each submission has exactly one result, of its files and this course.
void refuse_incomplete(const Roster& roster, const Results& results) {
    std::vector<std::string> missing, twice, stale, strangers;
    std::set<std::string> known;
    for (const Roster::One& one : roster.submissions) {
        known.insert(one.name);
        const auto found = results.find(one.name);
        if (found == results.end()) {
            missing.push_back(one.name);
            continue;
        }
        const SubmissionMark& mark = found->second.front();
        if (found->second.size() > 1)
            twice.push_back(one.name);
        else if (mark.hash != one.hash || mark.course != roster.course)
            stale.push_back(one.name);
    }
    for (const auto& [name, marks] : results)
        if (!known.contains(name)) strangers.push_back(name);
    std::vector<std::string> problems;
    const auto add = [&](const std::vector<std::string>& names, const char* what) {
        if (!names.empty()) problems.push_back(fmt::format("{} {}: {}", names.size(), what, some_of(names)));
    };
    add(missing, "without a result");
    add(twice, "with several results");
    add(stale, "with a result of other files");
    add(strangers, "not of this class");
    if (!problems.empty())
        throw Error(fmt::format("of {} submissions {}", roster.submissions.size(), join(problems, "; ")));
}

}  // namespace

std::vector<fs::path> class_parts(const fs::path& folder) {
    std::vector<fs::path> parts;
    const auto add = [&](const fs::path& one) {
        std::error_code unknown;
        if (fs::exists(one / "class.json", unknown)) parts.push_back(one);
    };
    add(folder);
    std::error_code unknown;
    if (fs::is_directory(folder, unknown))
        for (const auto& entry : fs::directory_iterator(folder)) add(entry.path());
    std::sort(parts.begin(), parts.end());
    if (parts.empty())
        throw UsageError(fmt::format("there is no class.json in '{}' or a folder in it", folder.string()));
    return parts;
}

ClassReport merge_class(const fs::path& folder) {
    const std::vector<fs::path> parts = class_parts(folder);
    const Roster roster = *read_roster(parts.front());
    std::map<std::string, Manifest> manifests;
    for (const LabEntry& lab : registry()) manifests.emplace(lab.folder, load_manifest(lab));
    Results results;
    for (const fs::path& part : parts) {
        refuse_another_class(*read_roster(part), part, roster, parts.front());
        read_results(part, manifests, results);
    }
    refuse_incomplete(roster, results);
    ClassReport report;
    report.seed = roster.seed;
    report.isolation.level = Isolation::namespaces;
    for (const Roster::One& one : roster.submissions) {
        SubmissionMark& mark = report.marks.emplace_back(std::move(results.at(one.name).front()));
        for (const LabMark& lab : mark.labs) report.times.add(lab.times);
        if (mark.isolation == name_of(Isolation::limits)) report.isolation = {Isolation::limits, "in a part of it"};
        report.seconds += mark.seconds;
    }
    return report;
}

}  // namespace relief::grade
