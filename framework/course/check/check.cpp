#include "framework/course/check/check.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/log.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/source_text.h"
#include "framework/core/base/text.h"
#include "framework/core/gl/gl.h"
#include "framework/core/image/file.h"
#include "framework/course/check/fingerprints.h"
#include "framework/course/check/hidden_checks.h"
#include "framework/course/check/kept_lab.h"
#include "framework/course/check/relation.h"
#include "framework/course/task/rules.h"

namespace relief::check {
namespace {

namespace fs = std::filesystem;

/// Returns the texts of the course's own task files.
TaskTexts course_texts() {
    return {.read = [](const std::string& file) -> std::optional<std::string> {
        const fs::path path = course_root() / file;
        return fs::exists(path) ? std::optional(read_source(path)) : std::nullopt;
    }};
}

/// Draws a shot again with each of vertex_moves.
std::vector<Image> moved_drawings(const LabEntry& lab, const Shot& shot, const NamedRenderer& renderer) {
    struct Moving {
        const NamedRenderer& renderer;
        ~Moving() { renderer.move_vertices({}); }
    } const moving{renderer};
    std::vector<Image> drawings;
    for (const glm::vec2 move : vertex_moves) {
        KeptLab kept(lab);  // a kept lab would keep its textures, which were drawn without the move
        renderer.move_vertices(move);
        drawings.push_back(draw_shot(kept.drawer_of(shot), shot));
    }
    return drawings;
}

/// The verdict on a check, and the picture that was drawn, usable or not.
struct CheckRun {
    Verdict said = {};
    Image drawn = {};  ///< empty if drawing failed or was not tried
    bool was_tried = false;
};

/// Compares the picture with `run.said.expected`, and keeps both.
void compare(KeptLab& kept, const Manifest& manifest, const CheckInfo& check, const NamedRenderer& renderer,
             CheckRun& run) {
    const std::string& probe = check.shot.probe.name;
    const ErrorMetric metric = probe.empty() ? ErrorMetric::distance : manifest.probe(probe).error;
    const Rasteriser rasteriser = rasteriser_of(renderer.name);
    Image expected = std::move(run.said.expected);
    Image judged = with_allowance(rasteriser, check, metric, run.drawn, expected);
    run.said = judge(manifest, check, judged, expected);
    if (rasteriser == Rasteriser::coarse && run.said.outcome == Outcome::wrong && renderer.move_vertices) {
        judged = with_allowance(rasteriser, check, metric, run.drawn, expected,
                                moved_drawings(kept.entry(), check.shot, renderer));
        run.said = judge(manifest, check, judged, expected);
    }
    tell_leftover(manifest, check, course_texts(), run.said);
    if (run.said.outcome == Outcome::wrong)
        if (auto relation = relation_of(manifest, check, judged, expected,
                                        [&] { return base_of(kept.entry(), manifest, check); })) {
            run.said.relation = relation->sentence;
            run.said.related = std::move(relation->predicted);
        }
    run.said.drawn = run.drawn;
    run.said.expected = std::move(expected);
}

CheckRun try_check(KeptLab& kept, const Manifest& manifest, const CheckInfo& check,
                   const std::optional<Image>& expected, const OtherShaders& others,
                   const NamedRenderer& renderer = {.name = "llvmpipe"}) {
    CheckRun run;
    try {
        if (auto why = judge_text(manifest, check, course_texts(), others)) {
            run.said = *std::move(why);
            if (expected) run.said.expected = *expected;
            return run;
        }
        run.was_tried = true;
        if (expected) run.said.expected = *expected;
        run.drawn = draw_shot(kept.drawer_of(check.shot), check.shot);
        refuse_unusable(run.drawn, check.shot);
        if (const Shot* const other = expected ? nullptr : &manifest.check(check.against).shot)
            run.said.expected = render_shot(kept.drawer_of(*other), *other);
        compare(kept, manifest, check, renderer, run);
    } catch (const Error& error) {
        kept.forget();
        run.said.outcome = Outcome::broken;
        run.said.found = error.what();
        run.said.culprit = culprit_of(manifest, error.what(), course_texts());
        run.said.details = error.details();
    } catch (const std::exception& error) {
        kept.forget();
        run.said.outcome = Outcome::broken;
        run.said.found = fmt::format("the task throws an exception: {}", error.what());
    }
    return run;
}

/// Returns no mistakes if their file is damaged or belongs to another manifest: the checks work without them.
Fingerprints known_mistakes(const LabEntry& lab, const Manifest& manifest) {
    try {
        return load_fingerprints(lab, manifest);
    } catch (const Error& error) {
        print_note(fmt::format("no mistake is named: {}", error.what()));
        return {};
    }
}

}  // namespace

Verdict run_check(const LabEntry& lab, const Manifest& manifest, const CheckInfo& check,
                  const std::optional<Image>& expected) {
    KeptLab kept(lab);
    return try_check(kept, manifest, check, expected, OtherShaders(lab, manifest)).said;
}

struct LabChecker::Memory {
    const LabEntry& lab;
    const Manifest& manifest;
    OtherShaders others;
    Fingerprints fingerprints;
    NamedRenderer renderer;
    HiddenByTask hidden = read_hidden_checks(lab);
    std::vector<Verdict> checks = {};
    Samples drawn = {};
};

NamedRenderer renderer_of_context() {
    if (!glGetString) return {};
    const auto* const name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    return {.name = name ? name : ""};
}

LabChecker::LabChecker(const LabEntry& lab, const Manifest& manifest, const NamedRenderer& renderer)
    : memory_(new Memory{lab, manifest, OtherShaders(lab, manifest), known_mistakes(lab, manifest), renderer}) {
    memory_->checks.resize(manifest.checks.size(), {Outcome::unfinished, "not checked"});
}
LabChecker::~LabChecker() = default;

const Verdict& LabChecker::run(size_t check, const std::optional<Image>& expected) {
    KeptLab kept(memory_->lab);
    return run(check, expected, kept);
}

const Verdict& LabChecker::run(size_t check, const std::optional<Image>& expected, KeptLab& kept) {
    const ComparableDrawing comparable;  // the window draws its own pictures with all that the GPU has
    auto& [lab, manifest, others, fingerprints, renderer, hidden, checks, drawn] = *memory_;
    CheckRun run = try_check(kept, manifest, manifest.checks[check], expected, others, renderer);
    checks[check] = std::move(run.said);
    drawn.erase(check);
    if (const auto places = fingerprints.checks.find(check); run.was_tried && places != fingerprints.checks.end())
        drawn[check] = sample_at(run.drawn, checks[check].found, places->second.values);
    return checks[check];
}

CheckResult LabChecker::take_result(size_t check) {
    CheckResult result{std::move(memory_->checks[check])};
    if (auto sample = memory_->drawn.extract(check)) result.sample = std::move(sample.mapped());
    return result;
}

void LabChecker::keep(size_t check, CheckResult result) {
    memory_->checks[check] = std::move(result.said);
    memory_->drawn.erase(check);
    if (result.sample) memory_->drawn[check] = *std::move(result.sample);
}

void LabChecker::set_renderer(const NamedRenderer& renderer) { memory_->renderer = renderer; }

std::vector<TaskVerdict> LabChecker::tasks() const {
    const Memory& memory = *memory_;
    const Exactness exactness = rasteriser_of(memory.renderer.name) == Rasteriser::exact ? Exactness() : other_renderer;
    const auto recognise = [&](const std::string& task, const std::vector<Verdict>& checks,
                               const std::vector<bool>& compared) -> std::optional<NamedMistake> {
        Samples own;
        for (const auto& [check, sample] : memory.drawn)
            if (compared[check] && memory.manifest.checks[check].task == task) own[check] = sample;
        const auto named = name_mistakes(memory.fingerprints, memory.manifest, checks, own, exactness);
        const auto found = named.find(task);
        if (found == named.end()) return {};
        return NamedMistake{"", found->second.mistake->hint, found->second.is_certain};
    };
    std::vector<TaskVerdict> tasks = judge_lab(memory.manifest, memory.checks, {.recognise = recognise});
    for (TaskVerdict& task : tasks)
        if (const auto found = memory.hidden.find(task.id); found != memory.hidden.end())
            task.hidden_checks = found->second.count, task.not_tested = found->second.not_tested;
    return tasks;
}

Manifest manifest_to_check(const LabEntry& lab) {
    Manifest manifest = load_manifest(lab);
    std::erase_if(manifest.checks,
                  [&](const CheckInfo& check) { return check.hidden && is_compared_with_itself(lab, check); });
    return manifest;
}

std::vector<size_t> checks_in_order(const Manifest& manifest) {
    std::vector<size_t> order;
    for (const TaskInfo& task : manifest.tasks)
        for (size_t i = 0; i < manifest.checks.size(); ++i)
            if (manifest.checks[i].task == task.id) order.push_back(i);
    std::stable_partition(order.begin(), order.end(), [&](size_t i) { return bool(manifest.checks[i].shot.calls); });
    return order;
}

std::optional<Image> expected_of(KeptLab& kept, const CheckInfo& check) {
    try {
        return expectation(kept, check);
    } catch (const std::exception&) {
        kept.forget();
        // The staff's task files are the solution. If they cannot be drawn, the check says why.
        if (check.against != "solution") throw;
        return {};
    }
}

}  // namespace relief::check
