#include "framework/course/pages/method_comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "framework/core/base/error.h"
#include "framework/core/lab/words.h"
#include "framework/library/maps/visualize.h"

namespace relief::pages {
namespace {

/// Ratio of the two ends of the scale of errors: three decades.
constexpr double decades = 1000;

/// Computes each exact picture once. Compares a few pixels to find whether the exact values depend on the method.
class Truths {
public:
    const Image& of(const Lab& lab, const Shot& shot) {
        Shot small = shot;
        small.size = {16, 12};
        const Image sample = truth_of(lab, small);
        if (whole_.pixel_count() == 0 || sample.values != sample_.values)
            whole_ = truth_of(lab, shot), sample_ = sample;
        return whole_;
    }

private:
    Image sample_, whole_;
};

CompareInfo usual(const Manifest& manifest) {
    CompareInfo usual;
    usual.knob = "method";
    usual.shot.camera = manifest.camera, usual.shot.size = CompareInfo::usual_size;
    return usual;
}

}  // namespace

std::optional<Comparison> compare_methods(const LabEntry& lab, const Manifest& manifest) {
    const CompareInfo info = manifest.compare.value_or(usual(manifest));
    const std::vector<KnobText> knobs = describe_knobs(*lab.make());
    const auto known =
        std::find_if(knobs.begin(), knobs.end(), [&](const KnobText& knob) { return knob.name == info.knob; });
    if (known == knobs.end() && !manifest.compare) return {};
    if (known == knobs.end()) set_knob(*lab.make(), info.knob, "");  // throws an error that lists the knobs
    const std::vector<std::string>& values = info.values.empty() ? known->choices : info.values;
    if (values.empty())
        throw UsageError(
            fmt::format("[compare]: the knob {} has no named values: say which, values = [\"1\", \"2\"]", info.knob));

    Comparison result;
    result.knob = info.knob;
    Probe probe = info.shot.probe;
    if (!manifest.compare && !manifest.probes.empty()) probe.name = manifest.probes.front().name;
    std::vector<double> kept;
    Truths truths;
    for (const std::string& value : values) {
        Shot shot = info.shot;
        shot.set.emplace_back(info.knob, value), shot.probe = {};
        ComparedMethod& method = result.methods.emplace_back(ComparedMethod{value, {}, {}, {}});
        const std::unique_ptr<Lab> drawn = make_lab(lab, shot);
        std::vector<PictureWord> left_out;  // the page names the method
        Shot picture = shot;
        picture.words = &left_out, picture.studio = true;
        method.picture = render_shot(*drawn, picture);
        if (!probe) continue;
        shot.probe = probe;
        shot.size = shot.size * 3 / 4;  // a probe needs no smooth edges, and its exact values are slow to compute
        const Image* truth = nullptr;
        try {
            truth = &truths.of(*drawn, shot);
        } catch (const UsageError&) {  // no exact values, as in a student's course
            probe = {};
            continue;
        }
        const Image measured = render_shot(*drawn, shot);
        method.error = error_image(measured, *truth, manifest.probe(probe.name).error);
        method.summary = summarize(*method.error);
        if (const std::string nothing = nothing_to_compare(measured, *truth, method.summary); !nothing.empty())
            throw Error(fmt::format("{}, {}={}: probe '{}': {}", lab.folder, info.knob, value, probe.name, nothing));
        result.measured = shot;
        kept.push_back(method.summary.p99);
    }
    if (kept.empty()) return result;
    result.probe = &manifest.probe(probe.name);
    result.max = error_map_max(*std::max_element(kept.begin(), kept.end()));
    return result;
}

double error_map_max(double p99) {
    if (!(p99 > 0)) return 1;
    const double power = std::pow(10, std::floor(std::log10(p99)));
    for (const double step : {1, 2, 5})
        if (p99 <= step * power * (1 + 1e-9)) return step * power;
    return 10 * power;
}

Image error_map(double max, const Image& error) {
    Image place = error;  // position on the scale, in [0, 1]
    for (float& value : place.values)
        if (std::isfinite(value)) value = float(std::max(0.0, std::log(value / max * decades) / std::log(decades)));
    return visualize_error(place, 1);
}

}  // namespace relief::pages
