// Frames of each lab, with the cameras of the manifest and of its reference screenshots.
#include "framework/course/manifest/manifest.h"
#include "framework/staff/measure/bench.h"
#include "framework/staff/measure/drawn_subject.h"

namespace relief::measure {
namespace {

/// Returns the error of the first probe with exact values, as the tests measure it.
BenchError error_of(const LabEntry& entry, const Manifest& manifest) {
    for (const ProbeInfo& probe : manifest.probes) {
        Shot shot{.size = {128, 128}, .time = 0, .camera = manifest.camera, .probe = {probe.name}, .set = {}};
        const auto lab = make_lab(entry, shot);
        const auto truth = find_truth(*lab, shot);
        if (!truth) continue;
        const ErrorSummary error = summarize(error_image(render_shot(*lab, shot), *truth, probe.error));
        return {error.mean, error.p99, error.largest, probe.unit};
    }
    return {};
}

std::vector<BenchScene> frames_scenes(const BenchSettings& settings) {
    BenchScene scene{{}, "frame"};
    for (const LabEntry& entry : registry()) {
        const Manifest manifest = load_manifest(entry);
        const auto add = [&](const std::string& name, Shot shot, const std::function<BenchError()>& error) {
            shot.size = settings.frame_size();
            scene.methods.push_back({entry.folder, {{"picture", name}}, [&entry, shot, error, settings] {
                                         const std::shared_ptr<Lab> lab = make_lab(entry, shot);
                                         BenchSubject subject = drawn(lab, shot);
                                         if (error) subject.error = error();
                                         if (settings.pictures) show_picture(subject, *lab, shot);
                                         return subject;
                                     }});
        };
        Shot first;
        first.camera = manifest.camera;
        std::function<BenchError()> error;
        if (!settings.is_first_look()) error = [&entry, manifest] { return error_of(entry, manifest); };
        add("manifest", first, error);
        for (const GoldenInfo& golden : manifest.goldens)
            if (!settings.quick && !golden.shot.probe) add(golden.name, golden.shot, {});
    }
    return {scene};
}

}  // namespace

const TopicRegistration frames_topic({"frames", "a frame of each lab, and the error of its probe",
                                      "How long does a frame of each lab take?", frames_scenes, true});

}  // namespace relief::measure
