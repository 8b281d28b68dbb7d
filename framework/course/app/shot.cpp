// relief shot: writes one picture, probe, exact value or error map to a file or to standard output.
#include <fmt/format.h>

#include <cmath>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/log.h"
#include "framework/core/base/text.h"
#include "framework/core/image/compare.h"
#include "framework/core/image/file.h"
#include "framework/core/lab/words.h"
#include "framework/course/app/shot.h"
#include "framework/course/app/shot_options.h"
#include "framework/course/manifest/manifest.h"
#include "framework/course/manifest/no_truth.h"
#include "framework/course/pages/picture_words.h"
#include "framework/library/kit/made_map.h"
#include "framework/library/maps/visualize.h"

namespace relief::app {
namespace {

struct ShotArguments {
    std::string lab, output, size, time, context = "auto", probe, truth, error, check, mistake, words;
    bool map = false;
    ShotOptions options;
};

double parse_time(const std::string& text) {
    const auto time = parse_number(text);
    if (!time || std::abs(*time) > 2e9)
        throw UsageError(fmt::format("--time takes seconds from -2000000000 to 2000000000, not '{}'", text));
    return *time;
}

enum class Show { picture, probe, truth, error, map };

Show what_to_show(const ShotArguments& arguments, Probe& probe) {
    if (!arguments.mistake.empty() && !arguments.truth.empty())
        throw UsageError("--mistake changes the drawn picture, so it does not go with --truth");
    const std::pair<Show, std::string> wanted[] = {
        {Show::probe, arguments.probe}, {Show::truth, arguments.truth}, {Show::error, arguments.error}};
    if (arguments.map && !arguments.mistake.empty())
        throw UsageError("--mistake changes the drawn picture, so it does not go with --map");
    Show show = arguments.map ? Show::map : Show::picture;
    for (const auto& [one, name] : wanted) {
        if (name.empty()) continue;
        if (show != Show::picture) throw UsageError("give only one of --probe, --truth, --error and --map");
        show = one;
        probe.name = name;
    }
    return show;
}

int take_shot(const ShotArguments& arguments) {
    const LabEntry& entry = find_lab(arguments.lab);
    const Manifest manifest = load_manifest(entry);
    Shot shot;
    shot.camera = manifest.camera;
    if (!arguments.check.empty()) shot = manifest.view_of_check(arguments.check);
    Show show = what_to_show(arguments, shot.probe);
    if (show == Show::picture && shot.probe) show = Show::probe;
    shot.probe.missing = MissingTask::told;
    shot.studio = arguments.check.empty();  // a check's picture has the bits that are compared
    if (!arguments.mistake.empty()) manifest.mistake(arguments.mistake);  // throws first if there is no such mistake
    const ErrorMetric metric = shot.probe ? manifest.probe(shot.probe.name).error : ErrorMetric::distance;
    if (!arguments.size.empty()) shot.size = parse_size(arguments.size);
    if (!arguments.time.empty()) shot.time = parse_time(arguments.time);
    arguments.options.apply(shot);

    const bool to_standard_output = arguments.output == "-";
    const std::string usual = entry.folder + (show == Show::map ? "-map.png" : ".png");
    const std::string output = arguments.output.empty() ? usual : arguments.output;
    const ImageFormat format =
        to_standard_output ? (shot.probe ? ImageFormat::pfm : ImageFormat::ppm) : format_of(output);
    const bool floats = format == ImageFormat::exr || format == ImageFormat::pfm;
    const ContextChoice choice = context_kind(arguments.context);
    std::unique_ptr<Context> context;  // must outlive the lab, which owns GL objects
    const std::unique_ptr<Lab> lab = make_lab(entry, shot);
    arguments.options.note_knobs_without_effect(*lab);
    print_event("lab: " + entry.folder);
    const auto draw = [&](bool light) {
        if (!arguments.mistake.empty())
            return draw_with_mistake(entry, arguments.mistake, shot, light && !shot.probe, choice);
        Image drawn = render_shot(*lab, shot, light);
        if (const size_t missing = shot.probe ? pixels_not_written(drawn) : 0; missing > 0)
            print_note(
                fmt::format("{} of {} pixels come from a task that is not written yet", missing, drawn.pixel_count()));
        return drawn;
    };

    const auto truth = [&] {
        std::optional<Image> found = find_truth(*lab, shot);
        if (!found) throw UsageError(no_truth(entry, shot));
        return *std::move(found);
    };

    std::vector<PictureWord> words, below;
    if (!arguments.words.empty()) shot.words = &words;
    Image image;
    std::string summary;
    if (show == Show::truth) {
        image = truth();
    } else if (show == Show::error) {
        const Image expected = truth();
        context = open_context(choice);
        const Image drawn = draw(false);
        image = error_image(drawn, expected, metric);
        const ErrorSummary error = summarize(image);
        if (const std::string nothing = nothing_to_compare(drawn, expected, error); !nothing.empty())
            throw Error(fmt::format("probe '{}': {}", shot.probe.name, nothing));
        summary = fmt::format("mean {}, rms {}, 99 % {}, largest {}, over {} pixels\n",
                              amount_of(error.mean, manifest.probe(shot.probe.name).unit, 6), plain(error.rms),
                              plain(error.p99), plain(error.largest), error.count);
        if (const OneSided sides = one_sided(drawn, expected); sides.count() > 0)
            summary += fmt::format("{} pixels have a surface only as it is drawn, {} only in the exact values\n",
                                   sides.measured, sides.truth);
        if (!floats) {
            const double scale = error.p99 > 0 ? error.p99 : 1;
            mark_one_sided(image, drawn, expected, scale);
            image = visualize_error(image, scale);
            below.push_back(pages::error_map_scale(amount_of(scale, manifest.probe(shot.probe.name).unit, 2)));
        }
    } else if (show == Show::map) {
        shot.probe = {};
        context = open_context(choice);
        draw_shot(*lab, shot);
        image = map_of(*lab);
    } else {
        context = open_context(choice);
        image = draw(floats);
    }
    if (!floats && (show == Show::probe || show == Show::truth))
        image = visualize_probe(image, manifest.probe(shot.probe.name).colors());

    if (shot.words) {
        words.insert(words.end(), below.begin(), below.end());
        write_file(arguments.words, pages::picture_words_markup(words));
    }
    const ColorSpace space = show == Show::map ? ColorSpace::linear : ColorSpace::srgb;
    if (to_standard_output) {
        write_standard_output(encode_image(image, format, {}, space));
        print_event("written");
    } else {
        write_image(output, image, {}, space);
        print_event("written: " + output);
        fmt::print("{}\n{}", output, summary);
    }
    return 0;
}

std::string knobs_and_probes(const std::string& lab_text) {
    if (lab_text.empty()) return "To list the knobs and probes of a lab: relief shot LAB --help";
    try {
        const LabEntry& entry = find_lab(lab_text);
        std::string text = fmt::format("Knobs of {} (--set name=value):\n", entry.folder);
        for (const KnobText& knob : describe_knobs(*entry.make()))
            text += fmt::format("  {:<14} {}; {} [{}]\n", knob.name, knob.help.line(), knob.range(), knob.value);
        text += "Probes:\n";
        for (const ProbeInfo& probe : load_manifest(entry).probes)
            text += fmt::format("  {:<14} {}\n", probe.name,
                                probe.unit.empty()                  ? "no unit"
                                : probe.error == ErrorMetric::angle ? "a direction; unit of its error: " + probe.unit
                                                                    : "unit: " + probe.unit);
        return text;
    } catch (const Error& error) {
        return error.what();
    }
}

class ShotCommand final : public Command {
public:
    void options(CommandOptions& options) override {
        options.lab(shot_.lab, true);
        options.value("-o", "FILE", shot_.output, "FILE.png, .exr, .ppm or .pfm, or - for standard output");
        options.value("--check", "NAME", shot_.check, "what this check draws, with its knobs, camera and probe");
        options.value("--size", "WxH", shot_.size, "size of the picture in pixels [1280x720, or the check's]");
        options.value("--time", "SECONDS", shot_.time, "time of an animation, in seconds [0]");
        options.value("--context", "NAME", shot_.context, context_help);
        shot_.options.options(options);
        options.value("--probe", "NAME", shot_.probe, "a quantity as the shader computes it, instead of the picture");
        options.value("--truth", "NAME", shot_.truth, "the exact value of that probe");
        options.value("--error", "NAME", shot_.error, "how far that probe is from its exact value");
        options.flag("--map", shot_.map, "the map that the lab makes, 16 bits, instead of the picture: 03, 07 and 09");
        if (draw_with_mistake)
            options.value("--mistake", "ID", shot_.mistake,
                          "draw with a known mistake: an id from the lab's staff/grading.toml");
        options.value("--words", "FILE.html", shot_.words,
                      "leave the words out of the picture, and write them as HTML to be laid over it");
        options.footer([this] { return knobs_and_probes(shot_.lab); });
    }
    int run() override { return take_shot(shot_); }

private:
    ShotArguments shot_;
};
RELIEF_COMMAND(ShotCommand, 4, "shot", "draws a picture of a lab, without a display");

}  // namespace

}  // namespace relief::app
