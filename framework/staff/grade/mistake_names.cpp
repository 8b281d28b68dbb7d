#include "framework/staff/grade/mistake_names.h"

namespace relief::grade {

MistakeNames::MistakeNames(const LabViews& views, const DrawnChecks& solution) : views_(views) {
    for (size_t i = 0; i < solution.checks.size(); ++i) solution_[i] = whole_sample(solution.checks[i].own);
}

/// Returns the fingerprints of a task. The first thread that needs them starts to draw the mistakes; threads that
/// arrive meanwhile draw the remaining ones.
const check::Fingerprints& MistakeNames::fingerprints(const std::string& task) const {
    const Manifest& manifest = views_.manifest();
    std::unique_lock lock(mutex_);
    const auto [place, is_new] = by_task_.try_emplace(task);
    OfTask& known = place->second;
    if (is_new) {
        known.mistakes = distinct_mistakes(manifest, task);
        known.drawn.resize(known.mistakes.size());
    }
    while (known.next < known.mistakes.size()) {
        const size_t i = known.next++;
        lock.unlock();
        DrawnProgram drawn = draw(*known.mistakes[i]);
        lock.lock();
        known.drawn[i] = std::move(drawn);
        if (++known.done < known.mistakes.size()) continue;
        const std::vector<size_t> checks = checks_with_fingerprints(manifest, task);
        DrawnProgram solution;
        for (const size_t check : checks) solution.push_back(std::move(solution_.extract(check).mapped()));
        add_fingerprints(known.prints, manifest, task, checks, solution, std::move(known.drawn));
        known.made.notify_all();
    }
    known.made.wait(lock, [&] { return known.mistakes.empty() || !known.prints.checks.empty(); });
    return known.prints;
}

DrawnProgram MistakeNames::draw(const MistakeInfo& mistake) const {
    const Manifest& manifest = views_.manifest();
    CourseFiles files = edited(mistake.edits);
    files.merge(solution_files(manifest));  // keeps the edited files
    const std::vector<size_t> checks = checks_with_fingerprints(manifest, mistake.task);
    std::vector<bool> wanted(manifest.checks.size());
    for (const size_t check : checks) wanted[check] = true;
    const DrawnChecks drawn = views_.draw(files, wanted, WhichViews::own);
    DrawnProgram program;
    for (const size_t check : checks) program.push_back(whole_sample(drawn.checks[check].own));
    return program;
}

std::optional<check::NamedMistake> MistakeNames::name(const std::string& task, const std::vector<check::Verdict>& said,
                                                      const DrawnChecks& drawn,
                                                      const std::vector<bool>& compared) const {
    const Manifest& manifest = views_.manifest();
    // Only a picture, or an error reported by the lab itself, can match a mistake.
    std::vector<size_t> checks = checks_with_fingerprints(manifest, task);
    std::erase_if(checks, [&](size_t check) { return !compared[check]; });
    if (std::none_of(checks.begin(), checks.end(), [&](size_t check) { return drawn.checks[check].own.told; }))
        return {};
    const check::Fingerprints& known = fingerprints(task);
    check::Samples samples;
    for (const size_t check : checks) {
        const DrawnAttempt& own = drawn.checks[check].own;
        const auto places = known.checks.find(check);
        if (places != known.checks.end())
            samples[check] = check::sample_at(own.image.value_or(Image()), own.error, places->second.values);
    }
    const auto named = check::name_mistakes(known, manifest, said, samples);
    const auto found = named.find(task);
    if (found == named.end()) return {};
    return check::NamedMistake{found->second.mistake->id, found->second.mistake->hint, found->second.is_certain};
}

}  // namespace relief::grade
