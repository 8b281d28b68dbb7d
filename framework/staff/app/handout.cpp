// relief handout: makes the students' course.
#include "framework/staff/handout/handout.h"

#include <fmt/format.h>

#include "framework/core/base/error.h"
#include "framework/core/base/text.h"
#include "framework/course/app/command.h"

namespace relief::app {
namespace {

namespace fs = std::filesystem;

/// `labs` is the argument of write_handout(); empty: none is passed.
int make_handout(const std::string& folder, const std::string& labs) {
    if (folder.empty()) throw UsageError("handout needs a folder for the students' course: -o FOLDER");
    pin_software_renderer();
    const auto context = open_context(std::nullopt);
    const handout::HandoutReport report =
        handout::write_handout(folder, labs.empty() ? std::optional<std::string>() : std::optional(labs));
    const handout::Delivery& done = report.delivery;
    if (!report.is_new) {  // in a new folder everything is new
        for (const std::string& file : done.added) fmt::print("new      {}\n", file);
        for (const std::string& file : done.updated) fmt::print("updated  {}\n", file);
        for (const std::string& file : done.removed) fmt::print("removed  {}, which the course no longer has\n", file);
        for (const auto& [file, beside] : done.kept)
            fmt::print("kept     your {}{}\n", file,
                       beside.empty() ? ", which the course no longer has"
                                      : "; the new version is beside it as " + fs::path(beside).filename().string());
        for (const std::string& path : done.not_open)
            fmt::print("left     {}, which is not a folder: nothing is written through a link\n", path);
        if (done.changed_nothing() && done.not_open.empty()) fmt::print("nothing to do: everything is up to date\n");
    }
    fmt::print("{}: {}{}, {}, {} files, {} of them expected pictures\n", folder, amount_of(report.labs, "lab"),
               report.choice == "all" ? "" : " (" + report.choice + ")", amount_of(report.tasks, "task"), report.files,
               report.expected);
    return 0;
}

class HandoutCommand final : public Command {
public:
    void options(CommandOptions& options) override {
        options.value("-o", "FOLDER", output_,
                      "a new folder, or a handout to update; files that its owner changed are not touched");
        options.value("--labs", "LABS", labs_, "labs to add, like 1-5 or 1,3,10-12 [a new folder: all; else none]");
    }
    int run() override { return make_handout(output_, labs_); }

private:
    std::string output_, labs_;
};
RELIEF_COMMAND(HandoutCommand, 11, "handout", "makes the students' course: starters, no solutions, no hidden checks");

}  // namespace

}  // namespace relief::app
