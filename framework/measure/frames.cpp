// Frames of each lab, as its manifest shows it and as its reference screenshots do, at 512 x 512, to their end on the
// renderer.
#include "framework/image/compare.h"
#include "framework/lab/manifest.h"
#include "framework/measure/topics.h"

namespace relief {
namespace {

constexpr glm::ivec2 size{512, 512};

/// Of the first probe that has a truth, as the tests hold it to.
BenchError error_of(const LabEntry& entry, const Manifest& manifest) {
    for (const ProbeInfo& probe : manifest.probes) {
        Shot shot{.size = {128, 128}, .time = 0, .camera = manifest.camera, .probe = {probe.name}, .set = {}};
        const auto lab = make_lab(entry, shot);
        const auto truth = lab->truth({0, shot.size, 0, Camera(shot.camera, 1), shot.probe}, shot.probe);
        if (!truth) continue;
        const ErrorSummary error = summarize(error_image(take(*lab, shot), *truth, probe.error));
        return {error.mean, error.p99, error.largest, probe.unit};
    }
    return {};
}

std::vector<BenchMethod> methods(const BenchSettings&) {
    std::vector<BenchMethod> result;
    const auto target = std::make_shared<Target>(TargetKind::picture, size);
    for (const LabEntry& entry : registry()) {
        const Manifest manifest = load_manifest(entry);
        const auto add = [&](const std::string& name, Shot shot, const BenchError& error) {
            shot.size = size;
            const std::shared_ptr<Lab> lab = make_lab(entry, shot);
            BenchMethod& method = result.emplace_back();
            method.name = entry.folder, method.item = "frame", method.knobs = {{"picture", name}}, method.error = error;
            method.run = [lab, target, shot] {
                draw_lab(*lab, frame_of(shot, *target));
                target->resolve();
                glFinish();
            };
        };
        Shot first;
        first.camera = manifest.camera;
        add("manifest", first, error_of(entry, manifest));
        for (const GoldenInfo& golden : manifest.goldens)
            if (!golden.shot.probe) add(golden.name, golden.shot, {});
    }
    return result;
}

}  // namespace

BenchTopic frames_topic() {
    return {"frames", "frames of each lab at 512 x 512, and the error of its probe", methods, true};
}

}  // namespace relief
