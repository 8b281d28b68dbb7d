#include "framework/course/check/expectation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "framework/core/base/error.h"
#include "framework/core/base/paths.h"
#include "framework/core/image/file.h"
#include "framework/course/check/kept_lab.h"

namespace relief::check {

namespace fs = std::filesystem;

namespace {

Image draw(KeptLab& kept, const Shot& shot) { return render_shot(kept.drawer_of(shot), shot); }

}  // namespace

fs::path expectation_file(const LabEntry& lab, const CheckInfo& check) {
    std::string name;
    for (const char c : check.name) name += std::isalnum(static_cast<unsigned char>(c)) ? char(std::tolower(c)) : '-';
    return course_root() / "labs" / lab.folder / "expected" / (name + (check.shot.probe ? ".exr" : ".png"));
}

std::optional<Image> expectation(const LabEntry& lab, const CheckInfo& check) {
    KeptLab kept(lab);
    return expectation(kept, check);
}

std::optional<Image> expectation(KeptLab& kept, const CheckInfo& check) {
    const ComparableDrawing comparable;  // as run() draws the picture that is compared with this one
    if (check.against != "truth" && check.against != "solution") return {};
    if (is_compared_with_itself(kept.entry(), check)) return draw(kept, check.shot);
    if (const fs::path file = expectation_file(kept.entry(), check); fs::exists(file)) return read_image(file);
    return truth_of(kept.drawer_of(check.shot), check.shot);
}

bool is_compared_with_itself(const LabEntry& lab, const CheckInfo& check) {
    return check.against == "solution" && !fs::exists(expectation_file(lab, check));
}

void tell_unproven(const LabEntry& lab, const CheckInfo& check, Verdict& said) {
    if (said.outcome != Outcome::passed || !is_compared_with_itself(lab, check)) return;
    said.outcome = Outcome::unproven;
    said.found =
        "nothing to compare with: here this file is its own solution; a course that relief handout makes has a "
        "reference";
}

void tell_unproven(const LabEntry& lab, const Manifest& manifest, std::vector<TaskVerdict>& tasks) {
    for (TaskVerdict& task : tasks)
        for (Verdict& said : task.checks) tell_unproven(lab, manifest.checks[said.index], said);
}

fs::path base_file(const LabEntry& lab, const CheckInfo& check) {
    fs::path file = expectation_file(lab, check);
    return file.replace_filename(file.stem().string() + "-base" + file.extension().string());
}

std::optional<Image> base_of(const LabEntry& lab, const Manifest& manifest, const CheckInfo& check) {
    if (!check.shot.probe) return {};
    const ProbeInfo& probe = manifest.probe(check.shot.probe.name);
    if (probe.without.empty()) return {};
    Shot shot = check.shot;
    shot.set.insert(shot.set.end(), probe.without.begin(), probe.without.end());
    try {
        if (const fs::path file = base_file(lab, check); fs::exists(file)) return read_image(file);
        return truth_of(*make_lab(lab, shot), shot);
    } catch (const Error&) {
        return {};  // no exact values, or a damaged file: without a base there are only fewer relations
    }
}

std::optional<Relation> relation_of(const Manifest& manifest, const CheckInfo& check, const Image& drawn,
                                    const Image& expected, const std::function<std::optional<Image>()>& base) {
    if (!drawn.same_shape(expected) || check.shot.calls) return {};
    if (!check.shot.probe) return relation_between(drawn, expected, {});
    const ProbeInfo& probe = manifest.probe(check.shot.probe.name);
    if (const auto& least = check.limits.at_least)
        if (summarize(error_image(drawn, expected, probe.error)).mean < *least) return {};
    Quantity quantity{.name = probe.name, .error = probe.error};
    auto relation = relation_between(drawn, expected, quantity);
    if ((relation && !relation->predicted.values.empty()) || probe.without.empty()) return relation;
    const std::optional<Image> without_relief = base();
    if (!without_relief) return relation;
    quantity.base = &*without_relief;
    for (const auto& [knob, value] : probe.without)
        quantity.base_knob += fmt::format("{}{} = {}", quantity.base_knob.empty() ? "" : ", ", knob, value);
    return relation_between(drawn, expected, quantity);
}

}  // namespace relief::check
