#include "framework/course/manifest/no_truth.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "framework/core/base/from_staff.h"
#include "framework/core/lab/lab.h"
#include "framework/course/manifest/manifest.h"

namespace relief {
namespace {

/// Returns a knob's setting that alone provides exact values, in the form of --set, and the probe that gets them. Tries
/// all values of toggles and choices on one pixel, so that labs need not describe when they have exact values. Empty if
/// there is no such setting.
std::pair<std::string, std::string> knob_with_truth(const LabEntry& entry, Shot shot) {
    std::vector<std::string> probes = {shot.probe.name};
    if (!shot.probe) {
        probes.clear();
        for (const ProbeInfo& probe : load_manifest(entry).probes) probes.push_back(probe.name);
    }
    shot.size = {1, 1};
    const auto lab = make_lab(entry, shot);
    std::vector<KnobText> knobs = describe_knobs(*lab);
    // Tries toggles first, because they change the scene less than choices.
    std::stable_partition(knobs.begin(), knobs.end(), [](const KnobText& knob) { return knob.is_toggle(); });
    for (const KnobText& knob : knobs) {
        for (const std::string& value : knob.choices) {
            if (value == knob.value) continue;
            set_knob(*lab, knob.name, value);
            for (const std::string& probe : probes) {
                shot.probe = {probe};
                if (find_truth(*lab, shot)) return {knob.name + "=" + value, probe};
            }
        }
        set_knob(*lab, knob.name, knob.value);
    }
    return {};
}

}  // namespace

std::string no_truth(const LabEntry& lab, const Shot& shot) {
    if (!staff_is_here())
        return fmt::format("the code that computes the exact values{} is not included in this course",
                           shot.probe ? fmt::format(" of '{}'", shot.probe.name) : "");
    const auto [knob, probe] = knob_with_truth(lab, shot);
    if (knob.empty())
        return shot.probe ? fmt::format("this lab has no exact values for the probe '{}'", shot.probe.name)
                          : "this lab has no exact values for any of its probes";
    return fmt::format("with these knobs there are no exact values for {}; with {} there are, {}",
                       shot.probe ? fmt::format("the probe '{}'", shot.probe.name) : "any probe", knob,
                       shot.probe ? "for this probe" : fmt::format("for '{}'", probe));
}

}  // namespace relief
