// Environment: the time of a frame of lab 16 with and without each of its terms. The errors of shadows by bias and map
// size, of occlusion by slices and taps, and of blurred mirror images.
#include "framework/staff/measure/bench.h"
#include "framework/course/manifest/manifest.h"
#include "framework/staff/measure/drawn_subject.h"

namespace relief::measure {
namespace {

Shot court_shot(const BenchSettings& settings, const BenchKnobs& set) {
    Shot shot;
    shot.size = settings.frame_size(), shot.camera = load_manifest(find_lab("16")).camera;
    shot.set = set;
    return shot;
}

/// A frame of the court with `set`, and the error of a probe in a separate shot.
BenchMethod method(const BenchSettings& settings, const char* name, const BenchKnobs& swept, const BenchKnobs& set,
                   const std::optional<Shot>& measured = {}, const char* unit = "share") {
    return {name, swept, [=] {
                const Shot shot = court_shot(settings, set);
                const std::shared_ptr<Lab> lab = make_lab(find_lab("16"), shot);
                BenchSubject subject = drawn(lab, shot);
                if (settings.pictures) show_picture(subject, *lab, shot);
                if (!measured) return subject;
                const auto exact = make_lab(find_lab("16"), *measured);
                const ErrorMetric metric =
                    measured->probe.name == "reflection" ? ErrorMetric::distance : ErrorMetric::absolute;
                const Image errors = error_image(render_shot(*exact, *measured), truth_of(*exact, *measured), metric);
                subject.error = error_over(errors, unit);
                subject.error.wrong.reset();
                if (settings.pictures) show_errors(subject, errors, 0.5);
                return subject;
            }};
}

BenchScene terms(const BenchSettings& settings) {
    BenchScene scene{{{"term", "all but"}}, "frame"};
    for (const char* off : {"nothing", "reflection", "shadow", "ao", "occlusion", "displace"})
        scene.methods.push_back(method(settings, off, {{"without", off}},
                                       off == std::string("nothing") ? BenchKnobs{} : BenchKnobs{{off, "false"}}));
    return scene;
}

BenchScene shadows(const BenchSettings& settings) {
    BenchScene scene{{{"term", "shadow"}}, "frame"};
    for (const char* texels : {"512", "1024", "2048"})
        for (const char* bias : {"none", "constant", "plane"}) {
            if (texels != std::string("1024") && bias != std::string("plane")) continue;
            const BenchKnobs set = {{"bias", bias}, {"shadow_texels", texels}, {"displace", "false"}};
            Shot shot = court_shot(settings, set);
            shot.size = {128, 128}, shot.probe = {"shadow"};
            scene.methods.push_back(method(settings, bias, {{"bias", bias}, {"texels", texels}}, set, shot));
        }
    return scene;
}

BenchScene occlusions(const BenchSettings& settings) {
    BenchScene scene{{{"term", "occlusion"}}, "frame"};
    for (const auto& [slices, taps] : {std::pair{"1", "4"}, {"2", "4"}, {"3", "5"}, {"4", "8"}, {"8", "16"}}) {
        Shot shot = court_shot(settings, {{"scene", "groove"}, {"tilt", "30"}, {"slices", slices}, {"taps", taps}});
        shot.size = {48, 128}, shot.probe = {"occlusion"};
        shot.camera = {.yaw = 0, .pitch = 89, .distance = 12, .target = {0, 0, 0}, .field_of_view = 40};
        scene.methods.push_back(method(settings, "horizons", {{"slices", slices}, {"taps", taps}},
                                       {{"slices", slices}, {"taps", taps}}, shot));
    }
    return scene;
}

BenchScene mirrors(const BenchSettings& settings) {
    BenchScene scene{{{"term", "mirrored sky"}}, "frame"};
    for (const char* exponent : {"8", "64", "512"}) {
        Shot shot =
            court_shot(settings, {{"gloss", "even"}, {"exponent", exponent}, {"level", "0"}, {"displace", "false"}});
        shot.size = {48, 48}, shot.probe = {"reflection"};
        shot.camera = {.yaw = 0, .pitch = 25, .distance = 3.2, .target = {1.9, 1.0, -1.1}, .field_of_view = 24};
        scene.methods.push_back(method(settings, "level", {{"exponent", exponent}},
                                       {{"gloss", "even"}, {"exponent", exponent}}, shot, "light"));
    }
    return scene;
}

BenchScene hidden_mirrors(const BenchSettings& settings) {
    BenchScene scene{{{"term", "mirror occlusion"}}, "frame"};
    for (const char* guess : {"none", "as-sky", "lagarde"}) {
        const BenchKnobs set = {{"mirror_occlusion", guess}};
        Shot shot = court_shot(settings, together({{"scene", "groove"},
                                                   {"gloss", "even"},
                                                   {"exponent", "64"},
                                                   {"tilt", "30"},
                                                   {"slices", "8"},
                                                   {"taps", "16"}},
                                                  set));
        shot.size = {48, 48}, shot.probe = {"mirror_open"};
        shot.camera = {.yaw = 0, .pitch = 60, .distance = 3, .target = {0, 0, 0}, .field_of_view = 40};
        scene.methods.push_back(method(settings, guess, set, set, shot));
    }
    return scene;
}

std::vector<BenchScene> environment_scenes(const BenchSettings& settings) {
    return {terms(settings), shadows(settings), occlusions(settings), mirrors(settings), hidden_mirrors(settings)};
}

}  // namespace

const TopicRegistration environment_topic(
    {.name = "environment",
     .help = "terms of the light in lab 16, and what hides them: time against error",
     .question = "What do light and shadow of a bumped surface cost, and how right are they?",
     .scenes = environment_scenes,
     .draws = true,
     .labs = {"16"}});

}  // namespace relief::measure
