// Lighting: the cost of each part, compiled in or left out, and the error of the shaded normal without it. The picture
// is timed, with four samples per pixel.
#include "framework/course/manifest/manifest.h"
#include "framework/staff/measure/bench.h"
#include "framework/staff/measure/drawn_subject.h"

namespace relief::measure {
namespace {

/// A lab's picture. If `probe` is named, it is compared with its exact values.
BenchMethod lit(const char* number, const std::string& name, const BenchKnobs& knobs, const BenchKnobs& set,
                const Orbit& camera, const std::string& probe, const BenchSettings& settings) {
    return {name, knobs, [=] {
                const LabEntry& entry = find_lab(number);
                const Manifest manifest = load_manifest(entry);
                Shot shot;
                shot.size = settings.frame_size();
                shot.camera = camera;
                shot.set = together(set, knobs);
                const std::shared_ptr<Lab> lab = make_lab(entry, shot);
                BenchSubject subject = drawn(lab, shot);
                if (settings.pictures) show_picture(subject, *lab, shot);
                for (const ProbeInfo& info : manifest.probes)
                    if (info.name == probe) {
                        Shot measured = shot;
                        measured.probe = {probe};
                        const Image errors =
                            error_image(render_shot(*lab, measured), truth_of(*lab, measured), info.error);
                        subject.error = error_over(errors, info.unit);
                        subject.error.wrong.reset();
                        if (settings.pictures) show_errors(subject, errors, 10);
                    }
                return subject;
            }};
}

// Close enough that a texel covers a pixel or more. So the error comes from the method and not from minification.

/// A brick column: with a normal map, or with vertex normals only.
BenchScene columns(const BenchSettings& settings) {
    BenchScene scene{{{"lab", "01_specular_highlights"}}, "frame"};
    for (const char* method : {"vertex-normal", "normal-map"})
        scene.methods.push_back(
            lit("01", method, {}, {{"method", method}},
                {.yaw = 0, .pitch = 8, .distance = 0.5, .target = {1.4, 1.3, 1.65}, .field_of_view = 20}, "normal",
                settings));
    return scene;
}

/// Leaning tangents, and a model that may be scaled: cases in which a pixel needs a correct frame.
BenchScene frames_of_pixels(bool is_scaled, const BenchSettings& settings) {
    BenchScene scene{{{"lab", "06_tangent_space"}, {"scaled", is_scaled ? "yes" : "no"}}, "frame"};
    BenchKnobs set = {{"view", "one"}, {"shape", "column"}, {"turn", "0"}, {"trouble", "leaning"}};
    for (const char* axis : {"scale_x", "scale_y", "scale_z"})
        if (!is_scaled) set.emplace_back(axis, "1");
    const auto add = [&](const char* name, const char* light_in, const char* gram_schmidt, const char* transpose,
                         bool peer = false) {
        scene.methods.push_back(
            lit("06", name, {{"light_in", light_in}, {"gram_schmidt", gram_schmidt}, {"inverse_transpose", transpose}},
                set, {.yaw = 0, .pitch = 4, .distance = 0.32, .target = {0, 0, 0.6}}, "normal", settings));
        scene.methods.back().peer = peer;
    };
    add("whole", "world", "on", "on");
    add("whole", "tangent", "on", "on");
    add("leaning", "world", "off", "on");
    add("unscaled", "world", "on", "off");
    // The usual tutorial code: the model matrix for tangents and normals alike, and light in tangent space.
    add("usual", "tangent", "off", "off", true);
    return scene;
}

/// A relief with different features compiled into its shader.
BenchScene permutations(const BenchSettings& settings) {
    BenchScene scene{{{"lab", "12_relief_exact"}, {"surface", "column"}}, "frame"};
    const auto add = [&](const char* name, const char* shadow, const char* depth, const char* outline) {
        scene.methods.push_back(lit("12", name, {{"shadow", shadow}, {"write_depth", depth}, {"outline", outline}},
                                    {{"view", "one"}, {"surface", "column"}}, load_manifest(find_lab("12")).camera, {},
                                    settings));
    };
    add("hit-alone", "none", "off", "off");
    add("shadow", "hard", "off", "off");
    add("soft-shadow", "soft", "off", "off");
    add("depth", "none", "on", "off");
    add("outline", "none", "off", "on");
    add("everything", "soft", "on", "on");
    return scene;
}

std::vector<BenchScene> lighting_scenes(const BenchSettings& settings) {
    return {columns(settings), frames_of_pixels(false, settings), frames_of_pixels(true, settings),
            permutations(settings)};
}

}  // namespace

const TopicRegistration lighting_topic(
    {.name = "lighting",
     .help = "parts of the shading, compiled in or left out, and the normal without them",
     .question = "What does each part of the shading cost?",
     .scenes = lighting_scenes,
     .draws = true,
     .labs = {"01", "06"}});

}  // namespace relief::measure
