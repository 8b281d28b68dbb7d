#include "framework/staff/grade/check_views.h"

#include <fmt/format.h>

#include <algorithm>

#include "framework/core/base/error.h"
#include "framework/staff/grade/variation.h"

namespace relief::grade {
namespace {

/// Returns the expected picture of a view; nothing for a check that compares with another check. Throws Error if this
/// view has no exact values.
std::optional<Image> expected_in(const LabEntry& lab, const CheckInfo& check, const Shot& shot,
                                 const DrawnAttempt& solution) {
    if (check.against == "truth") return truth_of(*make_lab(lab, shot), shot);
    if (check.against == "solution") return solution.image;
    return {};
}

constexpr double least_limit = 10;  ///< seconds

size_t count_hidden(const std::vector<CheckViews>& views) {
    return size_t(std::count_if(views.begin(), views.end(), [](const CheckViews& one) { return one.hidden; }));
}

/// Calls have no view that could differ.
size_t count_varied(const std::vector<CheckViews>& views) {
    return size_t(std::count_if(views.begin(), views.end(), [](const CheckViews& one) { return !one.own.shot.calls; }));
}

}  // namespace

std::string slowness(double cpu, double solution_cpu) {
    const double times = cpu / std::max(solution_cpu, 0.05);
    if (!(times > 20)) return {};
    return fmt::format("it takes {:.0f} times the processor time of the solution, {:.1f} seconds", times, cpu);
}

LabViews::LabViews(const LabEntry& lab, const Stage& stage, GradeSetup setup)
    : lab_(lab),
      stage_(stage),
      setup_(std::move(setup)),
      manifest_(load_manifest(lab)),
      derives_limit_(setup_.seconds == 0) {
    const size_t count = manifest_.checks.size();
    if (count == 0) throw Error(fmt::format("labs/{}/lab.toml: there is no [[check]]", lab.folder));
    if (derives_limit_) setup_.seconds = AttemptLimits{}.cpu;
    for (const CheckInfo& check : manifest_.checks) views_.push_back({.own = {check.shot}});
    const CourseFiles files = solution_files(manifest_);
    solution_ = draw(files, std::vector<bool>(count, true), WhichViews::own, {}, true);
    compiled_ = std::move(solution_.compiled);
    for (size_t i = 0; i < count; ++i) {
        const CheckInfo& check = manifest_.checks[i];
        views_[i].own.expected = expected_in(lab, check, check.shot, solution_.checks[i].own);
        views_[i].own.solution_cpu = solution_.checks[i].own.cpu;
        if (const check::Verdict said = judge(own(i, solution_)); said.outcome != check::Outcome::passed)
            throw Error(fmt::format("lab {}: nothing can be graded here: its own solution does not pass '{}' ({}: {})",
                                    lab.two_digits(), check.name, name_of(said.outcome), said.found));
    }
    solution_cpu_ = solution_.cpu;
    if (!setup_.seed.empty()) solution_cpu_ += find_hidden_views(files);
    bound_by(solution_cpu_);
}

void LabViews::bound_by(double solution_cpu) {
    if (!derives_limit_) return;
    setup_.seconds = std::max(least_limit, 10 * solution_cpu);
    if (solution_cpu_ > setup_.seconds)
        throw Error(fmt::format(
            "lab {}: its solution takes {:.1f} seconds of processor time here, and {:.1f} where the class was started: "
            "grade it on a machine that is not so slow, or give --seconds",
            lab_.two_digits(), solution_cpu_, solution_cpu));
}

// An entry's name is a hash of the shaders' texts. So an entry that two texts of the task files lead to comes from
// neither: it holds no answer. All entries come from the course's own files, and each process gets them as a copy in
// its own memory. So nothing goes from one submission to another.
//
// The second text is the solution with a comment. This leaves most entries: the starter ignores its inputs, so that the
// stages before it compile to something else. But a C++ task could read the entries, so there they must agree with the
// starter's, and hold no answer even if a driver's names ignored comments.
void LabViews::reuse_shaders() {
    if (stage_.isolation() == Isolation::limits) return;  // without a /tmp of its own there is no cache
    CourseFiles files;
    bool has_cpp = false;
    for (const auto& [file, text] : solution_files(manifest_)) {
        has_cpp |= !is_shader(file);
        files[file] = is_shader(file) ? text + "\n//\n" : text;
    }
    if (has_cpp) std::erase_if(files, [](const auto& file) { return is_shader(file.first); });
    shared_ = draw(files, std::vector<bool>(views_.size(), true), WhichViews::both, {}, true).compiled;
    std::erase_if(shared_, [&](const auto& entry) { return !compiled_.contains(entry.first); });
}

size_t LabViews::hidden_count() const { return count_hidden(views_); }

/// Chooses the hidden views that the solution passes. Returns the solution's processor time there, in seconds.
double LabViews::find_hidden_views(const CourseFiles& solution) {
    constexpr int attempts = 4;
    std::vector<CheckViews> best = views_;
    double cpu = 0;
    for (int attempt = 0; attempt < attempts && count_hidden(best) < count_varied(best); ++attempt) {
        const Variation variation(manifest_, lab_.folder, setup_.seed, attempt);
        for (CheckViews& views : views_)
            if (!views.own.shot.calls) views.hidden = View{variation.vary(views.own.shot)};
        DrawnChecks drawn = draw(solution, std::vector<bool>(views_.size(), true), WhichViews::hidden, {}, true);
        compiled_.merge(drawn.compiled);
        keep_passing_views(drawn);
        if (count_hidden(views_) <= count_hidden(best)) continue;
        std::swap(views_, best);
        cpu = drawn.cpu;
    }
    views_ = std::move(best);
    return cpu;
}

void LabViews::keep_passing_views(const DrawnChecks& solution) {
    std::vector<bool> passes(views_.size());
    for (size_t i = 0; i < views_.size(); ++i) {
        if (!views_[i].hidden) continue;
        View& view = *views_[i].hidden;
        try {
            view.expected = expected_in(lab_, manifest_.checks[i], view.shot, solution.checks[i].hidden);
            view.solution_cpu = solution.checks[i].hidden.cpu;
            passes[i] = judge(hidden(i, solution)).outcome == check::Outcome::passed;
        } catch (const Error&) {
            passes[i] = false;  // this view has no exact values
        }
    }
    // A check that compares with another needs the other's hidden view, which may in turn need a third check's.
    for (bool changed = true; changed;) {
        changed = false;
        for (size_t i = 0; i < views_.size(); ++i) {
            if (!passes[i] || passes[compared_with(i)]) continue;
            passes[i] = false;
            changed = true;
        }
    }
    for (size_t i = 0; i < views_.size(); ++i)
        if (!passes[i]) views_[i].hidden.reset();
}

/// Returns the check that this check compares with; the check itself if there is none.
size_t LabViews::compared_with(size_t check) const {
    const std::string& against = manifest_.checks[check].against;
    if (against == "truth" || against == "solution") return check;
    return size_t(&manifest_.check(against) - manifest_.checks.data());
}

std::vector<bool> LabViews::with_compared(std::vector<bool> checks) const {
    std::vector<bool> all = checks;
    for (size_t i = 0; i < checks.size(); ++i)
        if (checks[i]) all[compared_with(i)] = true;
    return all;
}

DrawnChecks LabViews::draw(const CourseFiles& files, const std::vector<bool>& checks, WhichViews which,
                           const std::string& alone) const {
    return draw(files, checks, which, alone, false);
}

DrawnChecks LabViews::draw(const CourseFiles& files, const std::vector<bool>& checks, WhichViews which,
                           const std::string& alone, bool keeps_compiled) const {
    DrawnChecks result;
    result.checks.resize(views_.size());
    std::vector<Shot> shots;
    std::vector<DrawnAttempt*> places;
    double cpu = 0;  // the solution's processor time for these shots
    const auto add = [&](const View& view, DrawnAttempt& place) {
        shots.push_back(view.shot);
        places.push_back(&place);
        cpu += view.solution_cpu;
    };
    const auto add_own = [&](bool of_hidden_checks) {
        const std::vector<bool> wanted = with_compared(checks);
        for (size_t i = 0; i < wanted.size(); ++i)
            if (wanted[i] && manifest_.checks[i].hidden == of_hidden_checks) add(views_[i].own, result.checks[i].own);
    };
    const auto add_hidden = [&] {
        std::vector<bool> wanted = checks;
        for (size_t i = 0; i < wanted.size(); ++i) wanted[i] = wanted[i] && views_[i].hidden;
        wanted = with_compared(wanted);
        for (size_t i = 0; i < wanted.size(); ++i)
            if (wanted[i]) add(*views_[i].hidden, result.checks[i].hidden);
    };
    if (which != WhichViews::hidden) add_own(false);
    const size_t public_count = shots.size();
    if (which != WhichViews::hidden) add_own(true);
    if (which != WhichViews::own) add_hidden();
    if (shots.empty()) return result;
    const double seconds = derives_limit_ && solution_cpu_ > 0
                               ? std::max(least_limit, setup_.seconds * std::min(1.0, cpu / solution_cpu_))
                               : setup_.seconds;
    Attempt drawn = attempt(stage_, lab_, files, shots, setup_.renderer, {seconds, setup_.memory}, public_count,
                            shared_, keeps_compiled, alone);
    for (size_t i = 0; i < places.size(); ++i) *places[i] = std::move(drawn.shots[i]);
    result.compile = drawn.compile;
    result.draw = drawn.draw;
    result.wasted = drawn.wasted;
    result.compiles_forever = drawn.compiles_forever;
    result.cpu = drawn.cpu;
    result.log = std::move(drawn.log);
    result.compiled = std::move(drawn.compiled);
    return result;
}

Comparison LabViews::own(size_t check, const DrawnChecks& drawn) const {
    const size_t other = compared_with(check);
    return {manifest_.checks[check], views_[check].own, drawn.checks[check].own, views_[other].own.shot,
            drawn.checks[other].own};
}

Comparison LabViews::hidden(size_t check, const DrawnChecks& drawn) const {
    const size_t other = compared_with(check);
    return {manifest_.checks[check], *views_[check].hidden, drawn.checks[check].hidden, views_[other].hidden->shot,
            drawn.checks[other].hidden};
}

check::Verdict LabViews::judge(const Comparison& one) const {
    if (!one.drawn.image) return {one.drawn.outcome, one.drawn.error};
    if (one.view.expected) return relief::check::judge(manifest_, one.check, *one.drawn.image, *one.view.expected);
    if (!one.other.image) return {one.other.outcome, one.other.error};
    try {
        refuse_unusable(*one.other.image, one.other_shot);
    } catch (const Error& error) {
        return {check::Outcome::broken, fmt::format("'{}': {}", one.check.against, error.what())};
    }
    return relief::check::judge(manifest_, one.check, *one.drawn.image, *one.other.image);
}

std::string LabViews::slowness(size_t check, const DrawnChecks& drawn) const {
    const CheckViews& views = views_[check];
    std::string said = grade::slowness(drawn.checks[check].own.cpu, views.own.solution_cpu);
    if (said.empty() && views.hidden)
        said = grade::slowness(drawn.checks[check].hidden.cpu, views.hidden->solution_cpu);
    return said;
}

}  // namespace relief::grade
