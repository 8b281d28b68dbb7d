// relief check: runs a lab's checks on a student's own work.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/folded_text.h"
#include "framework/core/base/log.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/process.h"
#include "framework/core/base/system.h"
#include "framework/core/base/text.h"
#include "framework/core/image/compare.h"
#include "framework/course/app/command.h"
#include "framework/course/check/check.h"
#include "framework/course/check/check_apart.h"
#include "framework/course/check/last_points.h"
#include "framework/course/check/verdict_json.h"
#include "framework/course/pages/check_page.h"
#include "framework/course/pages/page.h"
#include "framework/library/kit/word_layout.h"

namespace relief::app {

namespace fs = std::filesystem;

namespace {

std::string colored(check::Outcome outcome, const std::string& word) {
    static const bool on = os::is_terminal(standard_output) && !std::getenv("NO_COLOR");
    if (!on) return word;
    return fmt::format("\x1b[{}m{}\x1b[0m",
                       outcome == check::Outcome::passed                                             ? 32
                       : outcome <= check::Outcome::waiting || outcome == check::Outcome::unfinished ? 33
                                                                                                     : 31,
                       word);
}

/// Prints a text after `before`, whose letters fill `indent` columns. On a terminal the text is broken at blanks, and
/// its further lines begin below its first one.
void print_after(const std::string& before, size_t indent, const std::string& text) {
    static const auto columns = size_t(os::terminal_columns(standard_output));
    constexpr size_t least = 20;  // letters of a line; a narrower terminal breaks lines itself
    std::vector<std::string> lines = {text};
    if (columns >= indent + least)
        lines = broken_into_lines(text, [&](const std::string& line) { return line.size() <= columns - indent; });
    for (size_t i = 0; i < lines.size(); ++i)
        fmt::print("{}{}\n", i == 0 ? before : std::string(indent, ' '), lines[i]);
}
void print_after(const std::string& before, const std::string& text) { print_after(before, before.size(), text); }

/// Prints results. Prints each hint once per task, and each compiler message once.
class Printer {
public:
    Printer(const LabEntry& lab, const Manifest& manifest) : lab_(lab), manifest_(manifest) {}

    /// Prints the messages of compilers, each once. One mistake keeps all checks from drawing that use its function.
    void print_messages(const std::vector<check::TaskVerdict>& tasks) {
        for (const check::TaskVerdict& task : tasks)
            for (const check::Verdict& result : task.checks) {
                if (result.outcome != check::Outcome::broken || check::reason_to_wait(result).empty() ||
                    !messages_.insert(result.found + unfolded_text(result.details).shown).second)
                    continue;
                fmt::print("{}\n", colored(result.outcome, result.found));
                for (const std::string& line : lines_for_terminal(result.details)) fmt::print("{}\n", line);
                fmt::print("\n");
            }
    }
    void print(const check::TaskVerdict& task) {
        print_after(task.id + "  ", fmt::format("{}: {} ({})", task.title, check::points_text(task), task.file));
        if (!task.hint.empty()) print_after("  look at: ", without_backticks(task.hint));
        hints_.clear();
        for (const check::Verdict& result : task.checks)
            if (check::reason_to_wait(result).empty()) print(result, task);
        for (const auto& [reason, checks] : check::waiting_checks(task)) {
            const check::Verdict& first = task.checks[checks.front()];
            print_outcome(first.outcome, checks.size() == 1 ? first.name : check::count_of_checks(checks.size()),
                          reason);
        }
        for (const std::string& demand : task.not_tested) print_after("  not tested here: ", '"' + demand + '"');
    }

private:
    void print_outcome(check::Outcome outcome, const std::string& name, const std::string& said) const {
        print_after("  " + colored(outcome, fmt::format("{:<10}", check::name_of(outcome))) + "  ", column,
                    name + ": " + said);
    }
    void print(const check::Verdict& result, const check::TaskVerdict& task) {
        const bool is_repeated = result.outcome == check::Outcome::broken && !messages_.insert(result.found).second;
        print_outcome(result.outcome, result.name, is_repeated ? "the same message as above" : result.found);
        if (result.outcome < check::Outcome::wrong || result.outcome == check::Outcome::unfinished || is_repeated)
            return;
        const std::string indent(column, ' ');
        for (const std::string& line : lines_for_terminal(result.details)) fmt::print("{}{}\n", indent, line);
        if (const std::string& reason = manifest_.check(result.name).reason;
            result.outcome == check::Outcome::wrong && !reason.empty())
            print_after(indent + "why this limit: ", reason);
        if (const std::string hint = pages::look_at(result); !hint.empty() && hints_.insert(hint).second)
            print_after(indent + "look at: ", without_backticks(hint));
        if (result.outcome != check::Outcome::wrong || manifest_.check(result.name).shot.calls) return;  // no view
        const std::string name = quoted_for_shell(result.name);
        // Commands are not broken, so that they can be copied.
        fmt::print("{}in the window: ./relief run {} --check {}\n", indent, lab_.two_digits(), name);
        const std::optional<glm::ivec2> worst = worst_pixel(result);
        if (worst && is_shader(task.file))
            fmt::print("{}the worst pixel: ./relief explain {} --check {} --pixel {},{}\n", indent, lab_.two_digits(),
                       name, worst->x, worst->y);
    }

    /// Returns the pixel with the largest error, from the upper left corner; nothing if no pixel can be compared.
    std::optional<glm::ivec2> worst_pixel(const check::Verdict& result) const {
        const Image &drawn = result.drawn, &expected = result.expected;
        if (drawn.values.empty() || drawn.width != expected.width || drawn.height != expected.height ||
            drawn.channels != expected.channels)
            return {};
        const std::string& probe = manifest_.check(result.name).shot.probe.name;
        const Image errors =
            error_image(drawn, expected, probe.empty() ? ErrorMetric::distance : manifest_.probe(probe).error);
        size_t worst = 0;
        float largest = 0;
        for (size_t i = 0; i < errors.values.size(); ++i)
            if (std::isfinite(errors.values[i]) && errors.values[i] > largest) worst = i, largest = errors.values[i];
        if (largest == 0) return {};
        return glm::ivec2(worst % size_t(errors.width), worst / size_t(errors.width));
    }

    static constexpr size_t column = 14;  ///< in which the names of checks begin

    const LabEntry& lab_;
    const Manifest& manifest_;
    std::set<std::string> hints_, messages_;
};

struct CheckOptions {
    std::string lab;
    bool json = false, open = false, patient = false;
    fs::path page = {};
};

/// Continues as the lab's program that finds faults in C++ tasks (framework/cmake/add_lab.cmake), if there is one.
void become_checker(const LabEntry& lab, const CheckOptions& options) {
    const fs::path here = os::executable(), checker = here.parent_path() / ("check-" + lab.two_digits());
    if (here.filename() == checker.filename() || !fs::exists(checker)) return;
    std::vector<std::string> command = {checker.string(), "check", lab.folder};
    if (options.json) command.push_back("--json");
    if (options.open) command.push_back("--open");
    if (options.patient) command.push_back("--patient");
    if (is_verbose()) command.push_back("--verbose");
    if (!options.page.empty()) command.insert(command.end(), {"-o", options.page.string()});
    become_program(command);
}

/// Runs a lab's checks on the course's files. Returns 1 if one did not pass, unless it is unproven. With `open` or
/// `page` it also writes a page with the pictures. The default place of the page is below the course's build folder.
int check_own_work(const CheckOptions& options) {
    const auto& [lab_text, json, open, patient, wanted_page] = options;
    fs::path page = wanted_page;
    const bool has_page = open || !page.empty();
    if (!page.empty() && page.extension() != ".html")
        throw UsageError(fmt::format("-o takes the name of an HTML file, like checks.html, not '{}'", page.string()));
    const LabEntry& lab = find_lab(lab_text);
    const Manifest manifest = check::manifest_to_check(lab);
    if (manifest.tasks.empty()) throw Error(fmt::format("lab {} has no tasks", lab.two_digits()));
    become_checker(lab, options);
    const fs::file_time_type saved = check::last_saved(manifest);
    const auto [tasks, driver] =
        check::check_lab_apart(lab, manifest, patient ? check::patient_limits : check::PatienceLimits(),
                               has_page ? check::KeptPictures::of_all : check::KeptPictures::of_failed);

    check::keep_points(lab, tasks, saved);
    bool all = true;
    Printer printer(lab, manifest);
    nlohmann::ordered_json report = {{"lab", lab.folder}, {"tasks", nlohmann::ordered_json::array()}};
    for (const check::TaskVerdict& task : tasks) {
        for (const check::Verdict& result : task.checks) all &= result.outcome <= check::Outcome::unproven;
        if (json) {
            report["tasks"].push_back(check::as_json(task));
            continue;
        }
        if (&task == &tasks.front()) printer.print_messages(tasks);
        printer.print(task);
    }
    if (json) {
        const check::PointSum sum = check::sum_of(tasks), optional = check::sum_of(tasks, true);
        report["points"] = sum.points, report["of"] = sum.of, report["waiting"] = sum.waiting;
        if (optional.of > 0)
            report["optional"] = {{"points", optional.points}, {"of", optional.of}, {"waiting", optional.waiting}};
        fmt::print("{}\n", report.dump(2));
    } else {
        fmt::print("{}\n", check::points_text(tasks));
    }
    if (has_page) {
        if (page.empty()) page = course_root() / "build" / "check" / (lab.folder + ".html");
        make_folder(fs::absolute(page).parent_path());
        write_file(page, pages::check_page(lab, manifest, tasks, driver));
        const std::string place = fs::absolute(page).lexically_normal().string();
        const bool opened = open && open_on_desktop(page);
        print_note((open && !opened ? "there is no program to open it with, so open it yourself: " : "the page: ") +
                   place);
    }
    return all ? 0 : 1;
}

class CheckCommand final : public Command {
public:
    void options(CommandOptions& options) override {
        options.lab(lab_, true);
        options.flag("--json", json_, "print the result as JSON, for scripts");
        options.flag("--open", open_, "show a page with the pictures in the browser");
        options.flag("--patient", patient_, "allow ten minutes, for a slow machine, in place of 20 seconds");
        options.value("-o", "FILE.html", page_, "write the page to this file; it opens only with --open");
    }
    int run() override { return check_own_work({lab_, json_, open_, patient_, page_}); }

private:
    std::string lab_, page_;
    bool json_ = false, open_ = false, patient_ = false;
};
RELIEF_COMMAND(CheckCommand, 6, "check", "checks your work on a lab: what is wrong, and what to look at next");

}  // namespace

}  // namespace relief::app
