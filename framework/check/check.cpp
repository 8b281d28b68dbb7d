#include "framework/check/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "framework/base/error.h"
#include "framework/base/file.h"
#include "framework/base/log.h"
#include "framework/base/paths.h"
#include "framework/base/text.h"
#include "framework/check/fingerprints.h"
#include "framework/check/reach.h"
#include "framework/check/starter.h"
#include "framework/gl/missing_tasks.h"
#include "framework/image/file.h"

namespace relief {
namespace {

namespace fs = std::filesystem;

/// Limits for pictures. In a trial they let through none of 26 visible one-line mistakes, and all noise of one driver.
constexpr double small_difference = 2.0 / 255 + 1e-6, large_difference = 32.0 / 255 + 1e-6;
constexpr double share_over_small = 0.0005;
constexpr size_t pixels_over_large = 4;

/// Of a vector that should have unit length. Rounding to 8 bits takes 0.007, and a mean of neighbours some more.
constexpr double unit_tolerance = 0.05;

constexpr const char* outcome_names[] = {"passed",  "wrong",       "unfinished",    "broken",
                                         "crashed", "out_of_time", "out_of_memory", "machine"};

/// The measured values with their limits, and whether all limits were kept.
class Findings {
public:
    void add(const char* what, double value, std::optional<double> limit, const std::string& unit) {
        if (!limit) return;
        const bool kept = value <= *limit;
        good_ &= kept;
        const int digits = digits_for(value, *limit);
        text_ += fmt::format("{}{} {}{}", text_.empty() ? "" : ", ", what, amount_of(value, unit, digits),
                             kept ? "" : fmt::format(" (at most {})", rounded(*limit, digits)));
    }
    /// A lower limit for the value that was added last.
    void must_reach(double value, std::optional<double> min) {
        if (!min || value >= *min) return;
        good_ = false;
        text_ += fmt::format(" (at least {})", rounded(*min, digits_for(value, *min)));
    }
    Judgement judgement() const { return {good_ ? Outcome::passed : Outcome::wrong, text_}; }

private:
    /// Three, or as many as tell a value from its limit.
    static int digits_for(double value, double limit) {
        int digits = 3;
        while (digits < 9 && value != limit && rounded(value, digits) == rounded(limit, digits)) ++digits;
        return digits;
    }
    bool good_ = true;
    std::string text_;
};

bool is_surface(const Image& image, size_t pixel) { return image.values[pixel * image.channels] != no_surface; }

/// Share of the pixels in which `expected` is of unit length and `drawn` is not: a direction's angle does not show it.
double share_not_unit(const Image& drawn, const Image& expected) {
    const auto length = [](const Image& image, size_t pixel) {
        const float* const v = &image.values[pixel * size_t(image.channels)];
        return std::sqrt(double(v[0]) * double(v[0]) + double(v[1]) * double(v[1]) + double(v[2]) * double(v[2]));
    };
    size_t count = 0;
    for (size_t i = 0; i < drawn.pixel_count(); ++i)
        if (is_surface(drawn, i) && is_surface(expected, i) && std::abs(length(expected, i) - 1) < unit_tolerance)
            count += !(std::abs(length(drawn, i) - 1) < unit_tolerance);
    return double(count) / double(drawn.pixel_count());
}

Judgement compare_probes(const CheckInfo& check, const ProbeInfo& probe, const Image& drawn, const Image& expected) {
    size_t only_one = 0, off = 0;
    for (size_t i = 0; i < drawn.pixel_count(); ++i) only_one += is_surface(drawn, i) != is_surface(expected, i);
    const Image error = error_image(drawn, expected, probe.error);
    const ErrorSummary summary = summarize(error);
    if (summary.count == 0) return {Outcome::broken, "there are no pixels to compare"};
    for (const float value : error.values) off += value > 1 && value != no_surface;
    Findings findings;
    const Limits& limits = check.limits;
    findings.add("mean", summary.mean, limits.mean, probe.unit);
    findings.must_reach(summary.mean, limits.at_least);
    findings.add("99 % within", summary.p99, limits.p99, probe.unit);
    findings.add("largest", summary.largest, limits.largest, probe.unit);
    findings.add(("share of pixels off by more than " + amount_of(1, probe.unit)).c_str(),
                 double(off) / double(summary.count), limits.wrong, "");
    if (double(only_one) > limits.outline * double(drawn.pixel_count()))
        findings.add("share of pixels with a surface in only one of the two pictures",
                     double(only_one) / double(drawn.pixel_count()), limits.outline, "");
    if (probe.error == ErrorMetric::angle && !probe.any_length && check.against == "truth")
        if (const double share = share_not_unit(drawn, expected); share > limits.outline)
            findings.add("share of pixels whose vector is not of unit length", share, limits.outline, "");
    if (summary.not_finite > 0)
        return {Outcome::wrong, fmt::format("{} pixels are not a number or have no direction", summary.not_finite)};
    return findings.judgement();
}

Judgement compare_pictures(const Image& drawn, const Image& expected) {
    const double pixels = double(drawn.pixel_count());
    Findings findings;
    findings.add("share of pixels off by more than 2/255",
                 double(difference(drawn, expected, small_difference).pixels_over) / pixels, share_over_small, "");
    findings.add("pixels off by more than 32/255", double(difference(drawn, expected, large_difference).pixels_over),
                 double(pixels_over_large), "");
    return findings.judgement();
}

Image draw(const LabEntry& lab, const Shot& shot) {
    const TellMissingTasks untold(false);  // of another task, which the check can do without
    return render_shot(*make_lab(lab, shot), shot);
}

bool has_failed(Outcome outcome) {
    return outcome != Outcome::passed && outcome != Outcome::unfinished && outcome != Outcome::machine;
}

/// How many other tasks can make it fail.
size_t dependences(const CheckInfo& check) { return check.needs.size() + check.leans_on.size(); }

/// Whether `other`'s task, and all that it depends on, are among the tasks that `check` depends on.
bool is_below(const CheckInfo& other, const CheckInfo& check) {
    const auto is_needed = [&](const std::string& task) { return check.depends_on(task); };
    return is_needed(other.task) && std::all_of(other.needs.begin(), other.needs.end(), is_needed) &&
           std::all_of(other.leans_on.begin(), other.leans_on.end(), is_needed);
}

/// Whether another task has passed none of its checks, on which a failed check depends, while the check's own task has
/// passed one that does without it.
bool is_anothers(const Manifest& manifest, const std::vector<Judgement>& said, size_t failed) {
    const CheckInfo& check = manifest.checks[failed];
    const auto is_attested = [&](const std::string& other) {
        for (size_t i = 0; i < said.size(); ++i)
            if (manifest.checks[i].task == check.task && said[i].outcome == Outcome::passed &&
                !manifest.checks[i].depends_on(other))
                return true;
        return false;
    };
    const auto has_only_failed = [&](const std::string& other) {
        size_t failures = 0;
        for (size_t i = 0; i < said.size(); ++i) {
            if (manifest.checks[i].task != other || said[i].outcome == Outcome::unfinished) continue;
            if (said[i].outcome == Outcome::passed) return false;
            ++failures;
        }
        return failures > 0;
    };
    return said[failed].outcome != Outcome::passed &&
           std::any_of(manifest.tasks.begin(), manifest.tasks.end(), [&](const TaskInfo& other) {
               return check.depends_on(other.id) && has_only_failed(other.id) && is_attested(other.id);
           });
}

}  // namespace

const char* name_of(Outcome outcome) { return outcome_names[int(outcome)]; }

Outcome outcome_of(const std::string& name) {
    for (int i = 0; i < int(std::size(outcome_names)); ++i)
        if (name == outcome_names[i]) return Outcome(i);
    throw Error("unknown outcome '" + name + "'");
}

double TaskResult::points() const {
    double passed = 0;
    for (const CheckResult& result : checks) passed += result.outcome == Outcome::passed;
    return task->points * passed / double(checks.size());
}

std::string waits_for(const CheckInfo& check, const std::function<bool(const std::string& task)>& is_written) {
    std::vector<std::string> open;
    for (const std::string& task : check.needs)
        if (!is_written(task)) open.push_back(task);
    if (open.empty()) return {};
    if (open.size() == 1) return fmt::format("waits for task {}, which is not written yet", open.front());
    const std::string last = open.back();
    open.pop_back();
    return fmt::format("waits for tasks {} and {}, which are not written yet", fmt::join(open, ", "), last);
}

std::vector<const CheckInfo*> put_right_first(const Manifest& manifest, const std::vector<Judgement>& said) {
    std::vector<const CheckInfo*> before(said.size());
    for (size_t i = 0; i < said.size(); ++i) {
        if (!has_failed(said[i].outcome)) continue;
        const CheckInfo& check = manifest.checks[i];
        const CheckInfo*& first = before[i];
        for (size_t j = 0; j < said.size(); ++j) {
            // The same message twice comes from a compiler, and names the place itself.
            const bool is_same = said[i].outcome == Outcome::broken && said[i].found == said[j].found;
            if (!has_failed(said[j].outcome) || is_same || !is_below(manifest.checks[j], check)) continue;
            if (!first || dependences(manifest.checks[j]) < dependences(*first)) first = &manifest.checks[j];
        }
    }
    return before;
}

std::vector<bool> blames_another(const Manifest& manifest, const std::vector<Judgement>& said) {
    const std::vector<const CheckInfo*> first = put_right_first(manifest, said);
    std::vector<bool> blames;
    for (size_t i = 0; i < said.size(); ++i) blames.push_back(first[i] || is_anothers(manifest, said, i));
    return blames;
}

std::vector<std::string> hints(const Manifest& manifest, const std::vector<Judgement>& said) {
    const std::vector<const CheckInfo*> before = put_right_first(manifest, said);
    std::vector<std::string> hints(said.size());
    for (size_t i = 0; i < said.size(); ++i)
        if (before[i])
            hints[i] = fmt::format("put task {} right first", before[i]->task);
        else if (said[i].outcome == Outcome::wrong)
            hints[i] = manifest.checks[i].look_at;
    return hints;
}

std::string points_text(double points) { return rounded(points, 4); }

fs::path expectation_file(const LabEntry& lab, const CheckInfo& check) {
    std::string name;
    for (const char c : check.name) name += std::isalnum(static_cast<unsigned char>(c)) ? char(std::tolower(c)) : '-';
    return course_root() / "labs" / lab.folder / "expected" / (name + (check.shot.probe ? ".exr" : ".png"));
}

std::optional<Image> expectation(const LabEntry& lab, const CheckInfo& check) {
    if (check.against != "truth" && check.against != "solution") return {};
    const fs::path file = expectation_file(lab, check);
    if (fs::exists(file)) return read_image(file);
    if (check.against == "solution") return draw(lab, check.shot);
    return truth_of(*make_lab(lab, check.shot), check.shot);
}

Judgement judge(const Manifest& manifest, const CheckInfo& check, const Image& drawn, const Image& expected) {
    try {
        refuse_unusable(drawn, check.shot);
    } catch (const Error& error) {
        return {Outcome::broken, error.what()};
    }
    if (!drawn.same_shape(expected)) return {Outcome::broken, "the expected picture has another size"};
    if (!check.shot.probe) return compare_pictures(drawn, expected);
    return compare_probes(check, manifest.probe(check.shot.probe.name), drawn, expected);
}

namespace {

/// run_check(), and what was drawn, usable or not.
struct CheckRun {
    CheckResult result;
    Image drawn = {};  ///< empty if nothing was drawn
    bool was_tried = false;
};

CheckRun try_check(const LabEntry& lab, const Manifest& manifest, const CheckInfo& check,
                   const std::optional<Image>& expected) {
    CheckRun run{{&check}};
    CheckResult& result = run.result;
    if (expected) result.expected = *expected;
    Judgement said;
    try {
        const auto is_written = [&](const std::string& task) {
            return !is_unfinished(read_file(course_root() / manifest.task(task).file), task);
        };
        if (!is_written(check.task)) {
            said = {Outcome::unfinished, "not written yet"};
        } else if (const std::string waits = waits_for(check, is_written); !waits.empty()) {
            said = {Outcome::unfinished, waits};
        } else {
            run.was_tried = true;
            const TellMissingTasks untold(false);
            run.drawn = draw_shot(*make_lab(lab, check.shot), check.shot);
            refuse_unusable(run.drawn, check.shot);
            result.drawn = run.drawn;
            if (!expected) result.expected = draw(lab, manifest.check(check.against).shot);
            said = judge(manifest, check, result.drawn, result.expected);
        }
    } catch (const Error& error) {
        said = {Outcome::broken, error.what()};
        result.details = error.more_details();
    }
    result.outcome = said.outcome;
    result.found = said.found;
    return run;
}

/// In the grader's words; or empty.
std::string what_reaches_beyond(const std::string& file, const OtherShaders& others) {
    if (!is_shader(file) || !fs::exists(course_root() / file)) return {};
    const std::string beyond = reaches_beyond(read_file(course_root() / file), others);
    return beyond.empty() ? "" : fmt::format("{} {}", file, beyond);
}

/// None where their file is damaged, or of another manifest: work can be checked all the same.
Fingerprints known_mistakes(const LabEntry& lab, const Manifest& manifest) {
    try {
        return load_fingerprints(lab, manifest);
    } catch (const Error& error) {
        print_note(fmt::format("no mistake is named: {}", error.what()));
        return {};
    }
}

}  // namespace

CheckResult run_check(const LabEntry& lab, const Manifest& manifest, const CheckInfo& check,
                      const std::optional<Image>& expected) {
    return try_check(lab, manifest, check, expected).result;
}

struct LabChecker::Memory {
    const LabEntry& lab;
    const Manifest& manifest;
    OtherShaders others;
    Fingerprints fingerprints;
    std::vector<Judgement> said;
    Samples drawn;
};

LabChecker::LabChecker(const LabEntry& lab, const Manifest& manifest)
    : memory_(new Memory{lab, manifest, OtherShaders(lab, manifest), known_mistakes(lab, manifest), {}, {}}) {
    memory_->said.resize(manifest.checks.size());
}
LabChecker::~LabChecker() = default;

CheckResult LabChecker::run(size_t check, const std::optional<Image>& expected) {
    auto& [lab, manifest, others, fingerprints, said, drawn] = *memory_;
    const std::string& file = manifest.task(manifest.checks[check].task).file;
    const std::string beyond = what_reaches_beyond(file, others);
    CheckRun run = beyond.empty() ? try_check(lab, manifest, manifest.checks[check], expected)
                                  : CheckRun{{&manifest.checks[check], Outcome::broken, beyond}};
    said[check] = {run.result.outcome, run.result.found};
    drawn.erase(check);
    if (const auto places = fingerprints.checks.find(check); run.was_tried && places != fingerprints.checks.end())
        drawn[check] = sample_at(run.drawn, run.result.found, places->second.values);
    return std::move(run.result);
}

Advice LabChecker::advice() const {
    const auto& [lab, manifest, others, fingerprints, said, drawn] = *memory_;
    Advice advice{hints(manifest, said), {}};
    for (const auto& [task, mistake] : name_mistakes(fingerprints, manifest, said, drawn))
        advice.mistakes[task] = mistake->hint;
    const std::vector<bool> blames = blames_another(manifest, said);
    for (size_t i = 0; i < said.size(); ++i)
        if (const auto mistake = advice.mistakes.find(manifest.checks[i].task);
            mistake != advice.mistakes.end() && has_failed(said[i].outcome) && !blames[i])
            advice.look_at[i] = mistake->second;
    return advice;
}

std::vector<TaskResult> check_lab(const LabEntry& lab, const Manifest& manifest, const Expected& expected) {
    LabChecker checker(lab, manifest);
    std::vector<TaskResult> results;
    Progress progress(int(manifest.checks.size()));
    for (const TaskInfo& task : manifest.tasks) {
        TaskResult& result = results.emplace_back(TaskResult{&task, {}});
        for (size_t i = 0; i < manifest.checks.size(); ++i) {
            const CheckInfo& check = manifest.checks[i];
            if (check.task != task.id) continue;
            progress.next(check.name);
            result.checks.push_back(checker.run(i, expected ? expected(check) : expectation(lab, check)));
        }
        if (result.checks.empty())
            throw Error(fmt::format("labs/{}/lab.toml: task {} has no check", lab.folder, task.id));
    }
    Advice advice = checker.advice();
    for (TaskResult& task : results) {
        task.mistake = advice.mistakes[task.task->id];
        for (CheckResult& result : task.checks)
            result.look_at = advice.look_at[size_t(result.check - manifest.checks.data())];
    }
    return results;
}

}  // namespace relief
