// relief list: lists the labs, or those of a path through the course.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "framework/core/base/error.h"
#include "framework/core/base/log.h"
#include "framework/core/base/text.h"
#include "framework/course/app/command.h"
#include "framework/course/check/last_points.h"
#include "framework/course/manifest/manifest.h"
#include "framework/course/manifest/paths.h"

namespace relief::app {
namespace {

struct ListedLab {
    const LabEntry* lab;
    Manifest manifest;
};

/// The columns of the table, 80 letters wide: numbers end below each other.
void print_row(const std::string& number, const std::string& name, const std::string& title, const std::string& hours,
               const std::string& points, const std::string& earned) {
    fmt::print("{:>2}  {:<22} {:<27} {:>5}  {:>8}  {:>8}\n", number, name, title, hours, points, earned);
}

void print_heading() { print_row("", "lab", "title", "hours", "points", "earned"); }

void print_lab(const ListedLab& one) {
    const Manifest& manifest = one.manifest;
    std::string points = manifest.tasks.empty() ? "" : std::to_string(manifest.points());
    if (manifest.optional_points() > 0) points += fmt::format(" + {}", manifest.optional_points());
    print_row(one.lab->two_digits(), one.lab->name, manifest.title + (manifest.elective ? " *" : ""),
              manifest.hours > 0 ? rounded(manifest.hours) : "", points,
              check::last_points(*one.lab, manifest).value_or("-"));
}

/// Explains the signs in the rows of these labs.
void print_legend(const std::vector<ListedLab>& labs) {
    const auto has = [&](const auto& sign) {
        return std::any_of(labs.begin(), labs.end(), [&](const ListedLab& one) { return sign(one.manifest); });
    };
    fmt::print("\n");
    if (has([](const Manifest& manifest) { return manifest.elective; })) fmt::print("* an elective lab\n");
    if (has([](const Manifest& manifest) { return manifest.optional_points() > 0; }))
        fmt::print("+ points of optional tasks\n");
    fmt::print("earned: at the last check, such as ./relief check {}; -: not checked, or edited since\n",
               labs.front().lab->two_digits());
}

void print_path(const CoursePath& path, const std::vector<ListedLab>& labs) {
    std::vector<const Manifest*> manifests;
    for (const ListedLab& one : labs) manifests.push_back(&one.manifest);
    const std::vector<CourseWeek> weeks = weeks_of(path, manifests);
    double hours = 0;
    for (size_t i = 0; i < weeks.size(); ++i) {
        if (weeks[i].labs.empty()) continue;
        fmt::print("week {}: {}\n", i + 1, hours_text(weeks[i].hours));
        for (const size_t lab : weeks[i].labs) print_lab(labs[lab]);
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
        if (json_) {
            print_json(labs);
        } else if (!labs.empty()) {
            print_heading();
            if (path)
                print_path(*path, labs);
            else
                for (const ListedLab& one : labs) print_lab(one);
            print_legend(labs);
        }
        return every_manifest_read ? 0 : 1;
    }

private:
    bool json_ = false;
    std::string path_ = "all";
};
RELIEF_COMMAND(ListCommand, 1, "list", "lists the labs with their hours, points, and the points you have");

}  // namespace

}  // namespace relief::app
