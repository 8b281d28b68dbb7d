#include "framework/staff/grade/mistake_names.h"

#include <cmath>

namespace relief {
namespace {

constexpr size_t max_samples = 16384;
/// An error in place of a picture counts as much as this many samples.
constexpr size_t error_weight = 1000;
/// The share of what differs from the solution that must agree with the mistake.
constexpr double min_agreement = 0.9;

/// Two NaNs are near each other, and so are two equal infinities.
bool is_near(float a, float b, double tolerance) {
    if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
    return a == b || std::abs(double(a) - b) <= tolerance;
}

}  // namespace

/// Samples of several checks may be added up.
struct MistakeNames::Likeness {
    size_t differ = 0;  ///< samples in which the drawing or the mistake differs from the solution
    size_t agree = 0;   ///< of those, the samples in which the drawing is like the mistake
};

MistakeNames::Sample::Sample(const DrawnAttempt& drawn) : error(drawn.error), is_drawn(drawn.image.has_value()) {
    if (!is_drawn) return;
    const Image& image = *drawn.image;
    const size_t step = (image.pixel_count() + max_samples - 1) / max_samples;
    for (size_t i = 0; i < image.pixel_count(); i += step)
        for (int c = 0; c < image.channels; ++c) values.push_back(image.values[i * size_t(image.channels) + size_t(c)]);
}

MistakeNames::MistakeNames(const LabViews& views, const DrawnChecks& solution) : views_(views) {
    for (const DrawnViews& one : solution.checks) solution_.emplace_back(one.own);
}

/// For a picture two steps of 8 bits. For a probe 2 % of the mistake's mean error: that works in any unit, and other
/// mistakes cost more.
double MistakeNames::tolerance_of(const Sample& mistake, const Sample& solution, bool is_probe) {
    if (!is_probe) return 2.0 / 255 + 1e-6;
    double sum = 0;
    size_t count = 0;
    for (size_t i = 0; i < mistake.values.size(); ++i) {
        const double error = std::abs(double(mistake.values[i]) - solution.values[i]);
        if (!std::isfinite(error) || error == 0) continue;
        sum += error;
        ++count;
    }
    return count > 0 ? 0.02 * sum / double(count) : 1e-6;
}

MistakeNames::Likeness MistakeNames::compare(const Sample& drawn, const Sample& mistake, const Sample& solution,
                                             bool is_probe) {
    if (!drawn.is_drawn || !mistake.is_drawn) {
        const bool same = drawn.is_drawn == mistake.is_drawn && drawn.error == mistake.error;
        return {.differ = error_weight, .agree = same ? error_weight : 0};
    }
    const double tolerance = tolerance_of(mistake, solution, is_probe);
    Likeness likeness;
    for (size_t i = 0; i < drawn.values.size(); ++i) {
        const float d = drawn.values[i], m = mistake.values[i], s = solution.values[i];
        if (is_near(d, s, tolerance) && is_near(m, s, tolerance)) continue;
        ++likeness.differ;
        likeness.agree += is_near(d, m, tolerance);
    }
    return likeness;
}

/// The first thread that needs the signatures starts to draw them. Threads that come meanwhile draw those that are
/// left.
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

std::map<size_t, MistakeNames::Sample> MistakeNames::samples_of(const MistakeInfo& mistake) const {
    const Manifest& manifest = views_.manifest();
    CourseFiles files = edited(mistake.edits);
    files.merge(solution_files(manifest));  // keeps the edited files
    std::vector<bool> checks;
    for (const CheckInfo& check : manifest.checks) checks.push_back(check.task == mistake.task);
    const DrawnChecks drawn = views_.draw(files, checks, WhichViews::own);
    std::map<size_t, Sample> samples;
    for (size_t i = 0; i < checks.size(); ++i)
        if (checks[i]) samples.emplace(i, Sample(drawn.checks[i].own));
    return samples;
}

/// Over all compared checks, the share of what differs from the solution that is like the mistake.
double MistakeNames::agreement(const Signature& signature, const std::vector<Sample>& drawn,
                               const std::vector<bool>& compared) const {
    Likeness sum;
    for (const auto& [check, sample] : signature.samples) {
        if (!compared[check]) continue;
        const bool is_probe(views_.manifest().checks[check].shot.probe);
        const Likeness one = compare(drawn[check], sample, solution_[check], is_probe);
        sum.differ += one.differ;
        sum.agree += one.agree;
    }
    return sum.differ > 0 ? double(sum.agree) / double(sum.differ) : 0;
}

std::optional<NamedMistake> MistakeNames::name(const std::string& task, const DrawnChecks& drawn,
                                               const std::vector<bool>& compared) const {
    const Manifest& manifest = views_.manifest();
    // Only a picture, or an error that the lab itself reported, can be like a mistake.
    bool any = false;
    for (size_t i = 0; i < manifest.checks.size(); ++i)
        any |= manifest.checks[i].task == task && compared[i] && drawn.checks[i].own.told;
    if (!any) return {};
    std::vector<Sample> samples;
    for (const DrawnViews& one : drawn.checks) samples.emplace_back(one.own);
    const MistakeInfo* best = nullptr;
    double best_agreement = min_agreement;
    for (const Signature& signature : signatures(task)) {
        const double share = agreement(signature, samples, compared);
        if (share <= best_agreement) continue;
        best_agreement = share;
        best = signature.mistake;
    }
    if (!best) return {};
    NamedMistake named{best->id, best->hint};
    for (const MistakeInfo& same : manifest.mistakes)
        if (same.same_as == named.id) named.hint += " Or: " + same.hint;
    return named;
}

}  // namespace relief
