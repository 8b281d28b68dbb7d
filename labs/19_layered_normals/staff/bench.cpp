// Layered normals: blends of two normals, in degrees by three questions; mappings by three planes; highlights of a far
// wall. The picture of lab 19 is timed.
#include "framework/staff/measure/bench.h"
#include "framework/course/manifest/manifest.h"
#include "framework/staff/measure/drawn_subject.h"

namespace relief::measure {
namespace {

/// What one scene compares: a knob's values, the first of them course's own, by a probe.
struct Comparison {
    BenchKnobs scene;
    const char* knob;
    std::vector<const char*> values;
    const char *own, *probe, *unit;
    ErrorMetric metric;
    double brightest;  ///< error of the map's brightest colour
};

BenchScene compared(const Comparison& comparison, const BenchSettings& settings) {
    BenchScene scene{comparison.scene, "frame"};
    const auto truth = std::make_shared<std::optional<Image>>();  // the same for every value of the knob
    for (const char* value : comparison.values)
        scene.methods.push_back({value,
                                 {{comparison.knob, value}},
                                 [=] {
                                     Shot shot;
                                     shot.size = settings.frame_size();
                                     shot.camera = load_manifest(find_lab("19")).camera;
                                     shot.set = together(comparison.scene, {{comparison.knob, value}});
                                     // A picture of one method; `far` shows all five when nothing is probed, and so is
                                     // not timed.
                                     Shot measured = shot;
                                     measured.size = glm::ivec2(settings.is_first_look() ? 64 : 128);
                                     measured.probe = {comparison.probe};
                                     const std::shared_ptr<Lab> lab = make_lab(find_lab("19"), shot);
                                     BenchSubject subject =
                                         drawn(lab, comparison.probe == std::string("highlight") ? measured : shot);
                                     if (settings.pictures) show_picture(subject, *lab, shot);
                                     if (!*truth) *truth = truth_of(*lab, measured);
                                     const Image errors =
                                         error_image(render_shot(*lab, measured), **truth, comparison.metric);
                                     subject.error = error_over(errors, comparison.unit);
                                     if (comparison.metric != ErrorMetric::angle) subject.error.wrong.reset();
                                     if (settings.pictures) show_errors(subject, errors, comparison.brightest);
                                     return subject;
                                 },
                                 value != std::string(comparison.own)});
    return scene;
}

std::vector<BenchScene> layers_scenes(const BenchSettings& settings) {
    std::vector<BenchScene> all;
    for (const auto& [question, own] : {std::pair{"heights-add", "pd"}, {"along-normal", "pd"}, {"in-frame", "rnm"}}) {
        if (settings.is_first_look() && question != std::string("heights-add")) continue;
        all.push_back(compared({{{"question", question}},
                                "blend",
                                {"linear", "overlay", "whiteout", "udn", "pd", "rnm", "swizzle"},
                                own,
                                "normal",
                                "degree",
                                ErrorMetric::angle,
                                10},
                               settings));
    }
    for (const char* sharpness : {"1", "4", "16"})
        if (!settings.quick || sharpness == std::string("4"))
            all.push_back(compared({{{"view", "solid"}, {"shape", "sphere"}, {"sharpness", sharpness}},
                                    "mapping",
                                    {"one-plane", "udn", "whiteout", "rnm", "gradient", "exact"},
                                    "exact",
                                    "normal",
                                    "degree",
                                    ErrorMetric::angle,
                                    10},
                                   settings));
    for (const BenchKnobs& lobe : {BenchKnobs{}, BenchKnobs{{"brdf", "ggx"}}})
        all.push_back(compared({together({{"view", "far"}}, lobe),
                                "filter",
                                {"plain", "derivatives", "toksvig", "lean", "samples"},
                                "lean",
                                "highlight",
                                "share",
                                ErrorMetric::absolute,
                                0.5},
                               settings));
    return all;
}

}  // namespace

const TopicRegistration layers_topic(
    {.name = "layers",
     .help = "lab 19: blends of two normals by the question that they answer, mappings by three planes, far highlights",
     .question = "Which blend of two normals is right?",
     .scenes = layers_scenes,
     .draws = true,
     .labs = {"19"}});

}  // namespace relief::measure
