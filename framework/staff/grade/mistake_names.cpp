#include "framework/staff/grade/mistake_names.h"

namespace relief::grade {
namespace {

constexpr size_t max_samples = 16384;

/// Returns evenly spaced pixels of a picture, or the error that replaced it.
check::Sample sample_of(const DrawnAttempt& drawn) {
    check::Sample sample{.values = {}, .error = drawn.error, .is_drawn = drawn.image.has_value()};
    if (!sample.is_drawn) return sample;
    const Image& image = *drawn.image;
    const size_t step = (image.pixel_count() + max_samples - 1) / max_samples;
    for (size_t i = 0; i < image.pixel_count(); i += step)
        for (int c = 0; c < image.channels; ++c)
            sample.values.push_back(image.values[i * size_t(image.channels) + size_t(c)]);
    return sample;
}

}  // namespace

std::string hint_with_same(const Manifest& manifest, const MistakeInfo& mistake) {
    std::string hint = mistake.hint;
    for (const MistakeInfo& other : manifest.mistakes)
        if (other.same_as == mistake.id) hint += " Or: " + other.hint;
    return hint;
}

MistakeNames::MistakeNames(const LabViews& views, const DrawnChecks& solution) : views_(views) {
    for (const DrawnViews& one : solution.checks) solution_.push_back(sample_of(one.own));
}

/// Returns the signatures of a task's mistakes. The first thread that needs them starts to draw them; threads that
/// arrive meanwhile draw the remaining ones.
const std::vector<MistakeNames::Signature>& MistakeNames::signatures(const std::string& task) const {
    std::unique_lock lock(mutex_);
    Signatures& known = by_task_[task];
    if (known.list.empty())
        for (const MistakeInfo& mistake : views_.manifest().mistakes)
            if (mistake.task == task && mistake.same_as.empty()) known.list.push_back({&mistake});
    while (known.next < known.list.size()) {
        Signature& signature = known.list[known.next++];
        lock.unlock();
        signature.samples = samples_of(*signature.mistake);
        lock.lock();
        ++known.done;
        known.one_more.notify_all();
    }
    known.one_more.wait(lock, [&] { return known.done == known.list.size(); });
    return known.list;
}

check::Samples MistakeNames::samples_of(const MistakeInfo& mistake) const {
    const Manifest& manifest = views_.manifest();
    CourseFiles files = edited(mistake.edits);
    files.merge(solution_files(manifest));  // keeps the edited files
    std::vector<bool> checks;
    for (const CheckInfo& check : manifest.checks) checks.push_back(check.task == mistake.task);
    const DrawnChecks drawn = views_.draw(files, checks, WhichViews::own);
    check::Samples samples;
    for (size_t i = 0; i < checks.size(); ++i)
        if (checks[i]) samples.emplace(i, sample_of(drawn.checks[i].own));
    return samples;
}

/// Returns the agreement with a mistake over all compared checks: among the values that differ from the solution, the
/// share in which the drawing matches the mistake. Returns 0 if a check does not match. (A check may pass in its own
/// view, which is compared, and fail in a hidden one.)
double MistakeNames::agreement(const Signature& signature, const std::vector<check::Sample>& drawn,
                               const std::vector<bool>& compared) const {
    check::Likeness sum;
    for (const auto& [check, sample] : signature.samples) {
        if (!compared[check] || views_.manifest().checks[check].shot.calls) continue;  // a few calls are no picture
        const bool is_probe(views_.manifest().checks[check].shot.probe);
        const check::Likeness one = check::likeness(drawn[check], sample, solution_[check], is_probe);
        if (!check::is_like(one, true)) return 0;
        sum.differ += one.differ;
        sum.agree += one.agree;
    }
    return sum.share();
}

std::optional<NamedMistake> MistakeNames::name(const std::string& task, const DrawnChecks& drawn,
                                               const std::vector<bool>& compared) const {
    const Manifest& manifest = views_.manifest();
    // Only a picture, or an error reported by the lab itself, can match a mistake.
    bool any = false;
    for (size_t i = 0; i < manifest.checks.size(); ++i)
        any |= manifest.checks[i].task == task && compared[i] && drawn.checks[i].own.told;
    if (!any) return {};
    std::vector<check::Sample> samples;
    for (const DrawnViews& one : drawn.checks) samples.push_back(sample_of(one.own));
    const MistakeInfo* best = nullptr;
    double best_agreement = 0;
    for (const Signature& signature : signatures(task)) {
        const double share = agreement(signature, samples, compared);
        if (share <= best_agreement) continue;
        best_agreement = share;
        best = signature.mistake;
    }
    if (!best) return {};
    return NamedMistake{best->id, hint_with_same(manifest, *best)};
}

}  // namespace relief::grade
