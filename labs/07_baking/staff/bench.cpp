// Baking: the time of a bake and the error of its map, by size, frame and triangles. Also the time of a frame with the
// fine model, the coarse model, and the coarse model with its map.
#include "framework/staff/measure/bench.h"
#include "framework/course/manifest/manifest.h"
#include "framework/staff/measure/drawn_subject.h"

namespace relief::measure {
namespace {

Shot shell_shot(const BenchSettings& settings, BenchKnobs set) {
    Shot shot;
    shot.size = settings.frame_size(), shot.camera = load_manifest(find_lab("07")).camera;
    shot.set = std::move(set), shot.set.emplace_back("view", "one");
    return shot;
}

void add_error(BenchSubject& subject, Lab& lab, Shot shot, const BenchSettings& settings) {
    if (settings.pictures) show_picture(subject, lab, shot);
    shot.probe = {"normal"};
    const Image errors = error_image(render_shot(lab, shot), truth_of(lab, shot), ErrorMetric::angle);
    subject.error = error_over(errors, "degree");
    subject.error.wrong.reset();
    if (settings.pictures) show_errors(subject, errors, 10);
}

/// A bake, including padding and mip levels, from an existing tree.
BenchMethod bake(const char* name, const BenchKnobs& knobs, const BenchKnobs& set, const BenchSettings& settings,
                 bool peer = false) {
    return {name, knobs,
            [=] {
                const Shot shot = shell_shot(settings, together(set, knobs));
                const std::shared_ptr<Lab> lab = make_lab(find_lab("07"), shot);
                Shot tiny = shot;
                tiny.size = {8, 8};
                BenchSubject subject = drawn(lab, tiny);
                add_error(subject, *lab, shot, settings);
                // A change of the reach forces a new bake.
                subject.run = [lab, draw = subject.run, odd = false]() mutable {
                    odd = !odd;
                    set_knob(*lab, "reach", odd ? "0.421" : "0.42");
                    draw();
                };
                return subject;
            },
            peer};
}

BenchScene bakes(const char* high, const BenchSettings& settings) {
    BenchScene scene{{{"high", high}}, "bake"};
    for (const char* size : {"64", "128", "256", "512", "1024"}) {
        if (settings.quick && std::string(size).size() > 3) continue;
        const auto add = [&](const char* name, const BenchKnobs& knobs, bool peer = false) {
            scene.methods.push_back(
                bake(name, {{"map_size", size}}, together({{"high", high}, {"level", "0"}}, knobs), settings, peer));
        };
        add("one-frame", {});
        add("object-space", {{"map", "object"}});
        // A map made for the interpolated frame, in a renderer that makes its frame orthonormal.
        add("two-frames", {{"frame", "gram-schmidt"}}, true);
    }
    return scene;
}

BenchScene frames(const BenchSettings& settings) {
    BenchScene scene{{{"shell", "drawn"}}, "frame"};
    const auto add = [&](const char* name, const BenchKnobs& knobs) {
        scene.methods.push_back({name, knobs, [=] {
                                     const Shot shot = shell_shot(settings, knobs);
                                     const std::shared_ptr<Lab> lab = make_lab(find_lab("07"), shot);
                                     render_shot(*lab, shot);  // the bake is not part of a frame
                                     BenchSubject subject = drawn(lab, shot);
                                     add_error(subject, *lab, shot, settings);
                                     return subject;
                                 }});
    };
    add("fine", {{"wears", "high"}, {"high", "16k"}});
    if (!settings.quick) add("fine", {{"wears", "high"}, {"high", "131k"}});
    add("coarse", {{"wears", "nothing"}, {"low", "500"}});
    for (const char* low : {"100", "500", "2000"}) add("map", {{"wears", "map"}, {"low", low}});
    return scene;
}

std::vector<BenchScene> baking_scenes(const BenchSettings& settings) {
    std::vector<BenchScene> all = {bakes("16k", settings)};
    if (!settings.quick) all.push_back(bakes("131k", settings)), all.push_back(bakes("1M", settings));
    all.push_back(frames(settings));
    return all;
}

}  // namespace

const TopicRegistration baking_topic({.name = "baking",
                                      .help = "bakes of lab 07's shell and frames of it: time against degrees",
                                      .question = "How fine must a baked map be, and how long does it take?",
                                      .scenes = baking_scenes,
                                      .draws = true,
                                      .labs = {"07"}});

}  // namespace relief::measure
