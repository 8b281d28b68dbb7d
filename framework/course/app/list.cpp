// relief list: lists the labs, or those of a path through the course.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "framework/core/base/error.h"
#include "framework/core/base/log.h"
#include "framework/course/app/command.h"
#include "framework/course/manifest/manifest.h"
#include "framework/course/manifest/paths.h"

namespace relief::app {
namespace {

struct ListedLab {
    const LabEntry* lab;
    Manifest manifest;
};

void print_lab(const ListedLab& one, const char* indent = "") {
    const Manifest& manifest = one.manifest;
    std::string facts;
    if (manifest.elective) facts = "elective";
    if (manifest.hours > 0) facts += (facts.empty() ? "" : ", ") + hours_text(manifest.hours);
    if (!manifest.tasks.empty()) facts += (facts.empty() ? "" : ", ") + points_of_lab(manifest);
    fmt::print("{}{:02}  {:<24} {}{}\n", indent, one.lab->number, one.lab->name, manifest.title,
               facts.empty() ? "" : " (" + facts + ")");
}

void print_path(const CoursePath& path, const std::vector<ListedLab>& labs) {
    std::vector<const Manifest*> manifests;
    for (const ListedLab& one : labs) manifests.push_back(&one.manifest);
    const std::vector<CourseWeek> weeks = weeks_of(path, manifests);
    double hours = 0;
    for (size_t i = 0; i < weeks.size(); ++i) {
        if (weeks[i].labs.empty()) continue;
        fmt::print("week {}: {}\n", i + 1, hours_text(weeks[i].hours));
        for (const size_t lab : weeks[i].labs) print_lab(labs[lab], "  ");
        hours += weeks[i].hours;
    }
    fmt::print("together {}\n", hours_text(hours));
}

void print_json(const std::vector<ListedLab>& labs) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const auto& [lab, manifest] : labs)
        all.push_back({{"number", lab->number},
                       {"name", lab->name},
                       {"title", manifest.title},
                       {"points", manifest.points()},
                       {"optional_points", manifest.optional_points()},
                       {"elective", manifest.elective},
                       {"hours", manifest.hours},
                       {"needs", manifest.needs},
                       {"weeks", manifest.weeks},
                       {"learns", manifest.learns}});
    fmt::print("{}\n", all.dump(2));
}

class ListCommand final : public Command {
public:
    void options(CommandOptions& options) override {
        options.flag("--json", json_, "print JSON, for scripts");
        options.value("--path", "NAME", path_, "labs of one way through the course: short, term or all [all]");
    }
    int run() override {
        const CoursePath* const path = path_ == "all" ? nullptr : &find_path(path_);
        std::vector<ListedLab> labs;
        bool every_manifest_read = true;
        for (const LabEntry& lab : registry()) try {
                Manifest manifest = load_manifest(lab);
                if (!path || manifest.weeks.contains(path->name)) labs.push_back({&lab, std::move(manifest)});
            } catch (const Error& error) {
                print_error(error.what());
                every_manifest_read = false;
            }
        if (json_)
            print_json(labs);
        else if (path)
            print_path(*path, labs);
        else
            for (const ListedLab& one : labs) print_lab(one);
        return every_manifest_read ? 0 : 1;
    }

private:
    bool json_ = false;
    std::string path_ = "all";
};
RELIEF_COMMAND(ListCommand, 1, "list", "lists the labs with titles, hours and points");

}  // namespace

}  // namespace relief::app
