// relief golden: compares or renews the reference screenshots.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <regex>
#include <sstream>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/log.h"
#include "framework/core/base/paths.h"
#include "framework/core/gl/gl.h"
#include "framework/core/image/compare.h"
#include "framework/core/image/file.h"
#include "framework/course/app/command.h"
#include "framework/course/manifest/manifest.h"
#include "framework/library/maps/visualize.h"

namespace relief::app {
namespace {

namespace fs = std::filesystem;

// With one Mesa version and the pinned software renderer, any two machines agree to 1/255.
constexpr double allowed = 1.0 / 255 + 1e-6;
constexpr const char* driver_note = "driver";

std::string driver_of(const Notes& notes) {
    for (const auto& [name, value] : notes)
        if (name == driver_note) return value;
    return "an unknown driver";
}

/// Rounds a picture to 8 bits, like its PNG: the colours of a probe lie between these steps.
Image stored(Image picture) {
    for (float& value : picture.values) value = float(std::round(255.0 * std::clamp(value, 0.0f, 1.0f)) / 255);
    return picture;
}

/// Returns the upstream Mesa version of a pinned llvmpipe, also through Vulkan; nothing for any other driver.
std::optional<std::string> pinned_mesa(const std::string& driver) {
    static const std::regex form("(?:zink \\()?llvmpipe .*Mesa ([0-9.]+).*, pinned to sse4\\.1");
    std::smatch found;
    if (!std::regex_match(driver, found, form)) return {};
    return found[1].str();
}

/// Shares of pixels that may differ by more than 1/255 and by more than 4/255.
struct Shares {
    double over_1 = 0, over_4 = 0;
};

/// Returns whether the driver translates to Vulkan, whose driver is Mesa's software renderer.
bool is_through_vulkan(const std::string& driver) { return driver.starts_with("zink (llvmpipe"); }

/// Returns the allowed shares: zero, unless reference and picture are from two versions of Mesa, or the picture was
/// drawn through Vulkan. Then they come from labs/another_mesa.txt.
Shares shares_allowed(const std::string& picture, const std::string& reference_driver, const std::string& driver) {
    const auto theirs = pinned_mesa(reference_driver), ours = pinned_mesa(driver);
    const bool is_vulkan = is_through_vulkan(driver);
    if (!theirs || !ours || (*theirs == *ours && !is_vulkan)) return {};
    const double newer = *theirs == *ours ? -1 : std::max(std::atof(theirs->c_str()), std::atof(ours->c_str()));
    const fs::path file = course_root() / "labs/another_mesa.txt";
    std::istringstream lines(fs::exists(file) ? read_file(file) : "");
    Shares others, own;
    bool holds = true, has_own = false;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string name;
        Shares percent;
        if (words >> name; name == "Vulkan") holds = is_vulkan;
        if (!(words >> percent.over_1)) continue;
        if (name == "Mesa") holds = percent.over_1 <= newer;
        if (!holds || !(words >> percent.over_4)) continue;
        if (name == "others") others = percent;
        if (name == picture) own = percent, has_own = true;
    }
    const Shares found = has_own ? own : others;
    return {found.over_1 / 100, found.over_4 / 100};
}

std::string same_within(const Difference& off) { return fmt::format("same within {:.0f}/255", off.largest * 255); }

class GoldenCheck {
public:
    /// With `judge`, a picture that differs is a failure.
    GoldenCheck(bool update, bool judge, fs::path output)
        : update_(update), judge_(judge), output_(std::move(output)) {}

    int failures = 0, pictures = 0;

    void check(const LabEntry& entry, const Manifest& manifest, const GoldenInfo& golden) {
        const fs::path file = course_root() / "labs" / entry.folder / "golden" / (golden.name + ".png");
        ++pictures;
        try {
            Shot shot = golden.shot;
            shot.studio = true;
            Image picture = render_shot(*make_lab(entry, shot), shot);
            if (shot.probe) picture = stored(visualize_probe(picture, manifest.probe(shot.probe.name).colors()));
            const std::string result = update_ ? renew(file, picture) : compare(file, picture);
            fmt::print("{}/{}: {}\n", entry.folder, golden.name, result);
        } catch (const Error& error) {
            print_error(fmt::format("{}/{}: {}", entry.folder, golden.name, error.what()));
            ++failures;
        }
    }

private:
    std::string compare(const fs::path& file, const Image& picture) const {
        if (!fs::exists(file)) throw Error({file}, "no reference: look at the picture, then renew with --update");
        Notes notes;
        const Image reference = read_image(file, &notes);
        const Difference off = difference(picture, reference, allowed);
        if (off.pixels_over == 0) return same_within(off);
        const Shares shares = shares_allowed(name_of(file), driver_of(notes), driver_);
        const size_t over_4 = difference(picture, reference, 4.0 / 255 + 1e-6).pixels_over;
        const auto within = [&](size_t pixels, double share) {
            return double(pixels) <= share * double(picture.pixel_count());
        };
        if (picture.same_shape(reference) && within(off.pixels_over, shares.over_1) && within(over_4, shares.over_4))
            return fmt::format(
                "same within 1/255 but for {} of {} pixels: the reference was made by Mesa {}, this is {}",
                off.pixels_over, picture.pixel_count(), *pinned_mesa(driver_of(notes)),
                *pinned_mesa(driver_) + (is_through_vulkan(driver_) ? " through Vulkan" : ""));
        if (!output_.empty()) write_difference(file, picture, reference);
        if (!judge_ && picture.same_shape(reference)) {
            const size_t over_16 = difference(picture, reference, 16.0 / 255 + 1e-6).pixels_over;
            const auto percent = [&](size_t pixels) { return 100 * double(pixels) / double(picture.pixel_count()); };
            return fmt::format("{:.2f} % of the pixels differ by more than 1/255, {:.2f} % by more than 16/255",
                               percent(off.pixels_over), percent(over_16));
        }
        std::string line = picture.same_shape(reference)
                               ? fmt::format("{} of {} pixels differ by more than 1/255, the most by {:.0f}/255",
                                             off.pixels_over, picture.pixel_count(), off.largest * 255)
                               : fmt::format("{}x{}, the reference is {}x{}", picture.width, picture.height,
                                             reference.width, reference.height);
        if (driver_of(notes) != driver_)
            line += fmt::format(" (the reference was made by {}, this is {})", driver_of(notes), driver_);
        throw Error(line);
    }

    std::string renew(const fs::path& file, const Image& picture) const {
        if (fs::exists(file)) {
            Notes notes;
            const Image reference = read_image(file, &notes);
            if (driver_of(notes) != driver_)
                throw Error({file}, fmt::format("not renewed: it was made by {}, this is {}; remove the file first if "
                                                "you mean to change the driver",
                                                driver_of(notes), driver_));
            // Keep a picture that passes. If it were renewed each time, it could drift away step by step.
            if (const Difference off = difference(picture, reference, allowed); off.pixels_over == 0)
                return same_within(off);
        }
        make_folder(file.parent_path());
        write_image(file, picture, {{driver_note, driver_}});
        return "renewed";
    }

    /// Returns a name such as "01_specular_highlights/close".
    static std::string name_of(const fs::path& file) {
        return (file.parent_path().parent_path().filename() / file.stem()).string();
    }

    void write_difference(const fs::path& file, const Image& picture, const Image& reference) const {
        std::string name = name_of(file);
        std::replace(name.begin(), name.end(), '/', '-');
        make_folder(output_);
        write_image(output_ / (name + "-now.png"), picture);
        write_image(output_ / (name + "-reference.png"), reference);
        if (picture.same_shape(reference))
            write_image(output_ / (name + "-difference.png"),
                        visualize_error(error_image(picture, reference, ErrorMetric::distance), 16.0 / 255));
    }

    bool update_, judge_;
    fs::path output_;
    std::string driver_ = describe_context().driver();
};

/// Checks all labs if `chosen` is empty. Writes the differences into `output` if it is given. On a GPU, lists
/// differences and judges none: the references are from the software renderer.
int check_golden(const std::string& chosen, bool update, const fs::path& output, ContextChoice choice) {
    std::vector<const LabEntry*> labs;
    if (chosen.empty())
        for (const LabEntry& entry : registry()) labs.push_back(&entry);
    else
        labs = find_labs(chosen);

    const bool on_gpu = choice == ContextKind::gpu;
    if (on_gpu && update) throw UsageError("--update needs the software renderer: leave out --context gpu");
    on_gpu ? draw_comparably() : pin_software_renderer();
    const auto context = open_context(choice);
    if (!on_gpu && !is_software_renderer())
        throw Error("reference screenshots are made and compared on Mesa's software renderer; this is " +
                    describe_context().renderer);
    GoldenCheck check(update, !on_gpu, output);
    for (const LabEntry* entry : labs) try {
            const Manifest manifest = load_manifest(*entry);
            for (const GoldenInfo& golden : manifest.goldens) check.check(*entry, manifest, golden);
        } catch (const Error& error) {
            print_error(error.what());
            ++check.failures;
        }
    if (check.pictures == 0 && check.failures == 0)
        throw Error(fmt::format("nothing was compared: there is no [[golden]] in {}",
                                labs.size() == 1 ? "labs/" + labs.front()->folder + "/lab.toml" : "any lab.toml"));
    return check.failures == 0 ? 0 : 1;
}

class GoldenCommand final : public Command {
public:
    void options(CommandOptions& options) override {
        options.lab(labs_, false);
        options.flag("--update", update_, "renew those that differ");
        options.value("-o", "FOLDER", output_, "write what differs: now, reference, difference");
        options.value("--context", "NAME", context_, context_help);
        options.footer(
            [] { return std::string("LAB may also be several labs: 1-5 or 1,3,10-12. Without it: all labs."); });
    }
    int run() override { return check_golden(labs_, update_, output_, context_kind(context_)); }

private:
    std::string labs_, output_, context_ = "auto";
    bool update_ = false;
};
RELIEF_COMMAND(GoldenCommand, 21, "golden", "compares pictures with the reference screenshots");

}  // namespace

}  // namespace relief::app
