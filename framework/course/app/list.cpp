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
    std::string hours = {}, points = {}, earned = {};  ///< cells of the table
};

/// Fills the columns of numbers. The points of numbers stand below each other.
void fill_columns(std::vector<ListedLab>& labs) {
    const auto fill = [&](std::string ListedLab::*column, size_t width, const auto& cell) {
        std::vector<std::string> cells;
        for (const ListedLab& one : labs) cells.push_back(cell(one));
        cells = aligned_at_points(std::move(cells), width);
        for (size_t i = 0; i < labs.size(); ++i) labs[i].*column = cells[i];
    };
    fill(&ListedLab::hours, 5,
         [](const ListedLab& one) { return one.manifest.hours > 0 ? rounded(one.manifest.hours) : std::string(); });
    fill(&ListedLab::points, 8, [](const ListedLab& one) {
        std::string points = one.manifest.tasks.empty() ? "" : std::to_string(one.manifest.points());
        if (one.manifest.optional_points() > 0) points += fmt::format(" + {}", one.manifest.optional_points());
        return points;
    });
    fill(&ListedLab::earned, 8,
         [](const ListedLab& one) { return check::last_points(*one.lab, one.manifest).value_or("-"); });
}

/// Prints a row of the table, 80 letters wide.
void print_row(const std::string& number, const std::string& name, const std::string& title, const std::string& hours,
               const std::string& points, const std::string& earned) {
    std::string row =
        fmt::format("{:>2}  {:<22} {:<27} {:>5}  {:>8}  {:>8}", number, name, title, hours, points, earned);
    row.erase(row.find_last_not_of(' ') + 1);
    fmt::print("{}\n", row);
}

void print_heading() { print_row("", "lab", "title", "hours", "points", "earned"); }

void print_lab(const ListedLab& one) {
    print_row(one.lab->two_digits(), one.lab->name, one.manifest.title + (one.manifest.elective ? " *" : ""), one.hours,
              one.points, one.earned);
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
    for (const auto& [lab, manifest, hours, points, earned] : labs)
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
            fill_columns(labs);
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
