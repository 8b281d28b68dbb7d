// Moving frames: normals of a skin by the methods of engines and with the gradient of its weights. Error in degrees
// over the whole skin against the time of a frame. Also a flock, by its bodies and triangles.
#include "framework/staff/measure/bench.h"
#include "framework/course/manifest/manifest.h"
#include "framework/staff/measure/drawn_subject.h"

namespace relief::measure {
namespace {

struct JointWay {
    const char *name, *blend, *normal_by;
    bool usual;
};
constexpr JointWay joint_ways[] = {{"gradient", "linear", "gradient", false},
                                   {"matrix", "linear", "matrix", true},
                                   {"inverse-transpose", "linear", "inverse-transpose", true},
                                   {"unit-cofactors", "linear", "unit-cofactors", true},
                                   {"dual-gradient", "dual-quaternion", "gradient", false},
                                   {"dual-rotation", "dual-quaternion", "matrix", true}};

/// A tube bent at its joint. Errors are over the whole skin, visible or not.
BenchScene joint(const BenchKnobs& pose, const BenchSettings& settings) {
    BenchScene scene{pose, "frame"};
    for (const JointWay& way : joint_ways)
        scene.methods.push_back(
            {way.name,
             {{"blend", way.blend}},
             [=] {
                 Shot shot;
                 shot.size = settings.frame_size();
                 shot.camera = {.yaw = -35, .pitch = 14, .distance = 2.9};
                 shot.set = together({{"view", "one"},
                                      {"shape", "tube"},
                                      {"blend", way.blend},
                                      {"normal_by", way.normal_by},
                                      {"bend", "0"},
                                      {"relief", "0"}},
                                     pose);
                 const std::shared_ptr<Lab> lab = make_lab(find_lab("18"), shot);
                 BenchSubject subject = drawn(lab, shot);
                 if (settings.pictures) show_picture(subject, *lab, shot);
                 Shot skin = shot;
                 skin.size = {96, 192}, skin.probe = {"normal"}, skin.set.emplace_back("view", "skin");
                 const std::shared_ptr<Lab> unrolled = make_lab(find_lab("18"), skin);
                 const Image errors =
                     error_image(render_shot(*unrolled, skin), truth_of(*unrolled, skin), ErrorMetric::angle);
                 subject.error = error_over(errors, "degree");
                 if (settings.pictures) show_errors(subject, errors, 30);
                 return subject;
             },
             way.usual});
    return scene;
}

/// The opening picture. The error of the texture position on each body stands for the flock's attributes.
BenchScene flock(const BenchSettings& settings) {
    BenchScene scene{{{"flock", "drawn"}}, "frame"};
    const auto add = [&](const char* name, const BenchKnobs& knobs) {
        scene.methods.push_back({name, knobs, [=] {
                                     Shot shot;
                                     shot.size = settings.frame_size();
                                     shot.camera = load_manifest(find_lab("18")).camera, shot.set = knobs;
                                     const std::shared_ptr<Lab> lab = make_lab(find_lab("18"), shot);
                                     BenchSubject subject = drawn(lab, shot);
                                     if (settings.pictures) show_picture(subject, *lab, shot);
                                     shot.size = {96, 96}, shot.probe = {"normal"};
                                     const Image errors =
                                         error_image(render_shot(*lab, shot), truth_of(*lab, shot), ErrorMetric::angle);
                                     subject.error = error_over(errors, "degree");
                                     if (settings.pictures) show_errors(subject, errors, 1);
                                     return subject;
                                 }});
    };
    for (const char* count : {"1", "50", "200"}) add("bodies", {{"instances", count}});
    for (const char* triangles : {"3072", "12288"}) add("triangles", {{"triangles", triangles}});
    if (!settings.quick) add("triangles-each", {{"instances", "200"}, {"flock_triangles", "12288"}});
    add("at-rest", {{"bend", "0"}});
    return scene;
}

std::vector<BenchScene> moving_frames_scenes(const BenchSettings& settings) {
    std::vector<BenchScene> all;
    for (const char* bend : {"30", "60", "90"})
        if (!settings.quick || bend == std::string("90")) all.push_back(joint({{"bend", bend}}, settings));
    for (const char* twist : {"60", "90", "120"})
        if (!settings.quick || twist == std::string("120")) all.push_back(joint({{"twist", twist}}, settings));
    all.push_back(flock(settings));
    return all;
}

}  // namespace

const TopicRegistration moving_frames_topic(
    {.name = "moving-frames",
     .help = "normals of lab 18's skin, in degrees against time; its flock by bodies and triangles",
     .question = "Which normals does a bent skin need?",
     .scenes = moving_frames_scenes,
     .draws = true,
     .labs = {"18"}});

}  // namespace relief::measure
