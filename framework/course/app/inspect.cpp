// relief inspect: analyses a map from another source.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "framework/core/base/error.h"
#include "framework/core/image/file.h"
#include "framework/course/app/command.h"
#include "framework/course/inspect/inspect.h"

namespace relief::app {
namespace {

const char* word_of(inspect::Outcome outcome) {
    switch (outcome) {
        case inspect::Outcome::good:
            return "good";
        case inspect::Outcome::note:
            return "note";
        case inspect::Outcome::fault:
            return "fault";
        case inspect::Outcome::unknown:
            return "unknown";
    }
    return "";
}

std::string count_of(int faults) {
    return faults == 0 ? "no faults" : fmt::format("{} fault{}", faults, faults == 1 ? "" : "s");
}

void print_text(const std::string& file, const Image& map, const inspect::Inspection& found) {
    fmt::print("{}: {} x {} texels, {} channel{} of {} bits\n", file, map.width, map.height, map.channels,
               map.channels == 1 ? "" : "s", map.bits);
    for (const inspect::Finding& one : found.findings) {
        const char* const sign = one.outcome == inspect::Outcome::good      ? ""
                                 : one.outcome == inspect::Outcome::unknown ? "?"
                                                                            : word_of(one.outcome);
        fmt::print("  {:<6} {:<10} {}: {}\n", sign, one.name, one.verdict, one.reason);
    }
    fmt::print("{}\n", count_of(found.faults()));
}

void print_json(const std::string& file, const Image& map, const inspect::Inspection& found) {
    nlohmann::ordered_json all = {{"file", file},         {"width", map.width},
                                  {"height", map.height}, {"channels", map.channels},
                                  {"bits", map.bits},     {"faults", found.faults()}};
    for (const inspect::Finding& one : found.findings) {
        nlohmann::ordered_json numbers = nlohmann::ordered_json::object();
        for (const auto& [name, value] : one.numbers) numbers[name] = value;
        all["findings"].push_back({{"name", one.name},
                                   {"outcome", word_of(one.outcome)},
                                   {"verdict", one.verdict},
                                   {"reason", one.reason},
                                   {"numbers", numbers}});
    }
    // A file name can contain bytes that are not valid UTF-8.
    fmt::print("{}\n", all.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

void print_legend(const std::string& picture, const inspect::Inspection& found) {
    fmt::print("{}\n", picture);
    for (const inspect::MarkColor& color : inspect::mark_colors()) {
        const auto count = std::count_if(found.marks.begin(), found.marks.end(),
                                         [&](uint8_t marks) { return (marks & color.mark) != 0; });
        if (count > 0) fmt::print("  {:<8} {}: {} texel{}\n", color.color, color.meaning, count, count == 1 ? "" : "s");
    }
}

class InspectCommand final : public Command {
public:
    void options(CommandOptions& options) override {
        options.word("MAP", map_, "a normal or height map: PNG, EXR, JPEG, PPM, PFM, or DDS (BC5)");
        options.words("HEIGHTS", heights_, "the heights that its normals are to agree with");
        options.flag("--json", json_, "print JSON, for scripts");
        options.value("-o", "PICTURE", picture_, "draw where the faults are: .png, .exr, .ppm or .pfm");
        options.footer([] {
            return std::string(
                "A map without fault is one that the course can use as it is: linear, of unit vectors, green up, and "
                "its\n"
                "borders repeat. Notes are what a program must know to read it.\n"
                "Exit code: 0 no fault, 1 a fault or a file that cannot be read, 2 wrong use.");
        });
    }
    int run() override {
        if (heights_.size() > 1)
            throw UsageError("inspect takes MAP and one file of HEIGHTS; --help shows the options");
        if (!picture_.empty()) format_of(picture_);
        const Image map = read_image(map_), heights = heights_.empty() ? Image() : read_image(heights_.front());
        const inspect::Inspection found = inspect::inspect(map, heights_.empty() ? nullptr : &heights);
        if (!picture_.empty()) write_image(picture_, inspect::picture_of_marks(map, found));
        if (json_)
            print_json(map_, map, found);
        else
            print_text(map_, map, found);
        if (!json_ && !picture_.empty()) print_legend(picture_, found);
        return found.faults() == 0 ? 0 : 1;
    }

private:
    std::string map_;
    std::vector<std::string> heights_;
    bool json_ = false;
    std::string picture_;
};
RELIEF_COMMAND(InspectCommand, 9, "inspect",
               "says what a normal or height map from elsewhere is, and what is wrong with it");

}  // namespace
}  // namespace relief::app
