// A planet: the error and the time of its maps, by size and by formula; and frames by levels and culling.
#include "framework/staff/measure/bench.h"
#include "framework/course/manifest/manifest.h"
#include "framework/staff/measure/drawn_subject.h"

namespace relief::measure {
namespace {

/// Regenerates all maps of the six faces: heights, slopes and normals.
BenchMethod maps(const char* name, const BenchKnobs& knobs, const BenchKnobs& set, int texels,
                 const BenchSettings& settings, bool peer = false) {
    return {name, knobs,
            [=] {
                Shot shot;
                shot.size = {3 * texels, 2 * texels};  // one pixel per texel
                shot.set = together({{"view", "faces"}, {"seed", "1"}, {"detail", "1"}}, set);
                const std::shared_ptr<Lab> lab = make_lab(find_lab("09"), shot);
                Shot tiny = shot;
                tiny.size = {12, 8};
                BenchSubject subject = drawn(lab, tiny);
                if (settings.pictures) show_picture(subject, *lab, shot);
                shot.probe = {"normal"};
                const Image errors = error_image(render_shot(*lab, shot), truth_of(*lab, shot), ErrorMetric::angle);
                subject.error = error_over(errors, "degree");
                subject.error.wrong.reset();
                if (settings.pictures) show_errors(subject, errors, 10);
                // A change of the height forces a new map.
                subject.run = [lab, draw = subject.run, odd = false]() mutable {
                    odd = !odd;
                    set_knob(*lab, "height", odd ? "0.999" : "1");
                    draw();
                };
                return subject;
            },
            peer};
}

BenchScene maps_of_level(int level, const BenchSettings& settings) {
    BenchScene scene{{{"level", std::to_string(level)}}, "maps"};
    for (const int texels : {64, 128, 256}) {
        if (texels > (settings.is_first_look() ? 64 : settings.quick ? 128 : 256)) continue;
        const auto add = [&](const char* name, const BenchKnobs& set, bool peer = false) {
            const BenchKnobs size = {{"level", std::to_string(level)}, {"texels", std::to_string(texels >> level)}};
            scene.methods.push_back(
                maps(name, {{"face", std::to_string(texels)}}, together(size, set), texels, settings, peer));
        };
        add("metric", {});
        add("b-by-cross", {{"normals", "b-by-cross"}}, true);
        add("right-angled", {{"normals", "right-angled"}}, true);
        add("no-gutter", {{"gutter", "false"}}, true);
        if (level > 0) add("1+2^level", {{"strength", "1+2^level"}}, true);
    }
    return scene;
}

/// From a tenth of the radius above the ground, with an error of at most two pixels.
BenchScene planet_frames(const BenchSettings& settings) {
    BenchScene scene{{{"planet", "drawn"}}, "frame"};
    const auto add = [&](const char* name, const BenchKnobs& knobs) {
        scene.methods.push_back(
            {name, knobs, [=] {
                 Shot shot;
                 shot.size = settings.frame_size(), shot.camera = load_manifest(find_lab("09")).camera;
                 shot.set = together(
                     {{"view", "planet"}, {"eye", "ground"}, {"altitude", "-1"}, {"tilt", "-35"}, {"texels", "32"}},
                     knobs);
                 const std::shared_ptr<Lab> lab = make_lab(find_lab("09"), shot);
                 render_shot(*lab, shot);  // making maps is not part of a frame
                 BenchSubject subject = drawn(lab, shot);
                 if (settings.pictures) show_picture(subject, *lab, shot);
                 shot.probe = {"normal"};
                 const Image errors = error_image(render_shot(*lab, shot), truth_of(*lab, shot), ErrorMetric::angle);
                 subject.error = error_over(errors, "degree");
                 subject.error.wrong.reset();
                 if (settings.pictures) show_errors(subject, errors, 30);
                 return subject;
             }});
    };
    for (const char* budget : {"1", "2", "4"}) add("by-error", {{"levels", "error"}, {"budget", budget}});
    if (settings.is_first_look()) return scene;
    for (const char* level : {"2", "3"}) add("uniform", {{"levels", "uniform"}, {"level", level}});
    for (const char* cull : {"none", "outside"})
        add("culling", {{"levels", "uniform"}, {"level", "3"}, {"cull", cull}});
    return scene;
}

std::vector<BenchScene> planet_scenes(const BenchSettings& settings) {
    return {maps_of_level(0, settings), maps_of_level(1, settings), planet_frames(settings)};
}

}  // namespace

const TopicRegistration planet_topic(
    {.name = "planet",
     .help = "maps of lab 09's planet by formula and size, in degrees against time; frames by levels",
     .question = "Which normals does a planet need?",
     .scenes = planet_scenes,
     .draws = true,
     .labs = {"09"}});

}  // namespace relief::measure
