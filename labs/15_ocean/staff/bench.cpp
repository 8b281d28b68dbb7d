// Ocean: the time and the error of a frame of lab 15. Normals by the rules by which shaders combine two maps, and the
// light of a far sea by the wave statistics that a pixel uses.
#include "framework/staff/measure/bench.h"
#include "framework/course/manifest/manifest.h"
#include "framework/staff/measure/drawn_subject.h"

namespace relief::measure {
namespace {

Shot sea_shot(const BenchSettings& settings, const BenchKnobs& set, const Orbit& camera) {
    Shot shot;
    shot.size = settings.frame_size(), shot.camera = camera;
    shot.set = together({{"view", "one"}, {"displace", "false"}}, set);
    return shot;
}

/// Two maps combined into one normal, seen from above.
BenchScene rules(const char* wind, const BenchSettings& settings) {
    BenchScene scene{{{"wind", wind}}, "frame"};
    for (const char* rule : {"slopes", "mean"})
        scene.methods.push_back(
            {rule,
             {{"combine", rule}},
             [=] {
                 const Shot shot = sea_shot(settings, {{"combine", rule}, {"wind", wind}, {"level", "0"}},
                                            {.yaw = 180, .pitch = 60, .distance = 20, .target = {0, 0, 0}});
                 const std::shared_ptr<Lab> lab = make_lab(find_lab("15"), shot);
                 BenchSubject subject = drawn(lab, shot);
                 if (settings.pictures) show_picture(subject, *lab, shot);
                 Shot probe = shot;
                 probe.probe = {"normal"};
                 const Image errors = error_image(render_shot(*lab, probe), truth_of(*lab, probe), ErrorMetric::angle);
                 subject.error = error_over(errors, "degree");
                 if (settings.pictures) show_errors(subject, errors, 10);
                 return subject;
             },
             std::string(rule) != "slopes"});
    return scene;
}

/// The sun's glitter path on a far sea: error as a share of a single slope's light at each pixel.
BenchScene far_seas(const char* wind, const BenchSettings& settings) {
    BenchScene scene{{{"far", wind}}, "frame"};
    for (const char* far : {"plain", "toksvig", "lean", "samples"}) {
        if (settings.is_first_look() && far == std::string("samples")) continue;
        scene.methods.push_back({far, {{"far", far}}, [=] {
                                     const Shot shot =
                                         sea_shot(settings, {{"far", far}, {"wind", wind}, {"light_pitch", "20"}},
                                                  {.yaw = 180, .pitch = 20, .distance = 1500, .target = {0, 0, 0}});
                                     const std::shared_ptr<Lab> lab = make_lab(find_lab("15"), shot);
                                     BenchSubject subject = drawn(lab, shot);
                                     if (settings.pictures) show_picture(subject, *lab, shot);
                                     Shot probe = shot;
                                     probe.size = {96, 96}, probe.probe = {"glitter"};
                                     const Image errors = error_image(render_shot(*lab, probe), truth_of(*lab, probe),
                                                                      ErrorMetric::absolute);
                                     subject.error = error_over(errors, "share");
                                     subject.error.wrong.reset();
                                     if (settings.pictures) show_errors(subject, errors, 0.2);
                                     return subject;
                                 }});
    }
    return scene;
}

BenchScene sea_frames(const BenchSettings& settings) {
    BenchScene scene{{{"waves", "raised"}}, "frame"};
    for (const char* budget : {"1", "3", "8"})
        scene.methods.push_back({"budget", {{"budget", budget}}, [=] {
                                     Shot shot = sea_shot(settings, {{"displace", "true"}, {"budget", budget}},
                                                          load_manifest(find_lab("15")).camera);
                                     const std::shared_ptr<Lab> lab = make_lab(find_lab("15"), shot);
                                     BenchSubject subject = drawn(lab, shot);
                                     if (settings.pictures) show_picture(subject, *lab, shot);
                                     shot.size = {128, 128}, shot.probe = {"height"};
                                     const Image errors = error_image(render_shot(*lab, shot), truth_of(*lab, shot),
                                                                      ErrorMetric::absolute);
                                     subject.error = error_over(errors, "metre");
                                     subject.error.wrong.reset();
                                     return subject;
                                 }});
    return scene;
}

std::vector<BenchScene> ocean_scenes(const BenchSettings& settings) {
    std::vector<BenchScene> all = {rules("6", settings)};
    if (!settings.quick) all.push_back(rules("15", settings));
    all.push_back(far_seas("6", settings));
    if (!settings.quick) all.push_back(far_seas("15", settings));
    all.push_back(sea_frames(settings));
    return all;
}

}  // namespace

const TopicRegistration ocean_topic(
    {.name = "ocean",
     .help = "normals of two maps, and the light of a far sea, in lab 15: time against error",
     .question = "How right can a far sea glitter, and at what price?",
     .scenes = ocean_scenes,
     .draws = true,
     .labs = {"15"}});

}  // namespace relief::measure
