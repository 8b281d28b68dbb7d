#include "framework/staff/grade/marks.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstring>
#include <mutex>
#include <set>

#include "framework/base/error.h"
#include "framework/base/file.h"
#include "framework/base/paths.h"
#include "framework/check/starter.h"
#include "framework/gl/shader_source.h"
#include "framework/staff/grade/variation.h"

namespace relief {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

/// What a submission's shader includes and the course's own does not: other files may know answers. Else empty.
std::string foreign_include(const std::string& file, const std::string& text) {
    if (!file.ends_with(".glsl")) return {};
    const std::set<std::string> own = included_by(read_file(course_root() / file));
    for (const std::string& name : included_by(text))
        if (!own.contains(name)) return name;
    return {};
}

/// Whether a failure of one of two tasks that are seen through each other is the other's: that one has passed no check
/// at all, and this one has passed one that does without the other.
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

// ---- which known mistake a picture shows ----

constexpr size_t samples = 16384;
/// What a failure in place of a picture weighs, as many samples.
constexpr size_t failure_weight = 1000;
/// The share of what differs from the solution that must be the mistake's.
constexpr double agreement = 0.9;

/// Near, or both of one kind that is no number.
bool is_near(float a, float b, double tolerance) {
    if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
    return a == b || std::abs(double(a) - b) <= tolerance;
}

/// A fiftieth of what the mistake costs on average: in any unit less than another mistake costs. Pictures: 2 steps.
template <class Sampled>
double tolerance_of(const Sampled& mistake, const Sampled& solution, bool probe) {
    if (!probe) return 2.0 / 255 + 1e-6;
    double sum = 0;
    size_t count = 0;
    for (size_t i = 0; i < mistake.values.size(); ++i) {
        const double off = std::abs(double(mistake.values[i]) - solution.values[i]);
        if (std::isfinite(off) && off > 0) sum += off, ++count;
    }
    return count > 0 ? 0.02 * sum / double(count) : 1e-6;
}

struct Likeness {
    size_t differ = 0;  ///< samples in which the picture or the mistake's differs from the solution's
    size_t agree = 0;   ///< of those, in which the two are the same
};

template <class Sampled>
void compare(const Sampled& drawn, const Sampled& mistake, const Sampled& solution, bool probe, Likeness& likeness) {
    if (!drawn.drawn || !mistake.drawn) {
        likeness.differ += failure_weight;
        if (!drawn.drawn && !mistake.drawn && drawn.error == mistake.error) likeness.agree += failure_weight;
        return;
    }
    const double tolerance = tolerance_of(mistake, solution, probe);
    for (size_t i = 0; i < drawn.values.size(); ++i) {
        const float d = drawn.values[i], m = mistake.values[i], s = solution.values[i];
        if (is_near(d, s, tolerance) && is_near(m, s, tolerance)) continue;
        ++likeness.differ;
        likeness.agree += is_near(d, m, tolerance);
    }
}

}  // namespace

/// Some pixels of a picture, evenly spread, or the failure that came in its place.
struct LabGrader::Sampled {
    std::vector<float> values;
    std::string error;
    bool drawn = false;

    Sampled() = default;
    Sampled(const std::optional<Image>& image, const std::string& failure);
};

LabGrader::Sampled::Sampled(const std::optional<Image>& image, const std::string& failure)
    : error(failure), drawn(image.has_value()) {
    if (!image) return;
    const size_t step = (image->pixel_count() + samples - 1) / samples;
    for (size_t i = 0; i < image->pixel_count(); i += step)
        for (int c = 0; c < image->channels; ++c)
            values.push_back(image->values[i * size_t(image->channels) + size_t(c)]);
}

struct LabGrader::Signature {
    const MistakeInfo* mistake;
    std::map<size_t, Sampled> pictures;  ///< by check, of its task
};

struct LabGrader::Lazy {
    std::vector<Sampled> solution;  ///< by check
    std::mutex mutex;
    struct OfTask {
        std::vector<Signature> list;
        size_t next = 0, done = 0;
        std::condition_variable one_more;
    };
    std::map<std::string, OfTask> of_task;
};

double LabMark::points() const {
    double sum = 0;
    for (const TaskMark& task : tasks) sum += task.points;
    return sum;
}
int LabMark::max_points() const {
    int sum = 0;
    for (const TaskMark& task : tasks) sum += task.of;
    return sum;
}
bool LabMark::graded() const {
    for (const TaskMark& task : tasks)
        for (const CheckMark& check : task.checks)
            if (check.outcome == Outcome::machine) return false;
    return true;
}

LabGrader::LabGrader(const LabEntry& lab, const Stage& stage, GradeSetup setup)
    : lab_(lab),
      stage_(stage),
      setup_(std::move(setup)),
      manifest_(load_manifest(lab)),
      lazy_(std::make_unique<Lazy>()) {
    if (manifest_.checks.empty()) throw Error(fmt::format("labs/{}/lab.toml: there is no [[check]]", lab.folder));
    CourseFiles solution;
    for (const std::string& file : task_files(manifest_)) solution[file] = read_file(course_root() / file);
    const bool as_it_takes = setup_.seconds == 0;
    if (as_it_takes) setup_.seconds = 120;
    for (size_t i = 0; i < manifest_.checks.size(); ++i) views_.push_back({i, manifest_.checks[i].shot});
    const Attempt pictures = draw(solution, std::vector<bool>(views_.size(), true));
    for (size_t i = 0; i < views_.size(); ++i) {
        lazy_->solution.push_back(Sampled(pictures.shots[i].image, pictures.shots[i].error));
        expect(views_[i], pictures, 0);
        if (const Judgement said = judge_view(i, pictures); said.outcome != Outcome::passed)
            throw Error(fmt::format("lab {}: nothing can be graded here: its own solution does not pass '{}' ({}: {})",
                                    lab.two_digits(), manifest_.checks[i].name, name_of(said.outcome), said.found));
    }
    if (!setup_.seed.empty()) look_from_hidden_views(solution);
    if (as_it_takes) {
        const double share = double(views_.size()) / double(manifest_.checks.size());
        setup_.seconds = std::max(20.0, 10 * share * pictures.draw);
    }
}

/// `first`: the index of the first of the views that are looked at in the same way.
void LabGrader::expect(View& view, const Attempt& solution, size_t first) const {
    const CheckInfo& check = manifest_.checks[view.check];
    if (check.against == "truth")
        view.expected = truth_of(*make_lab(lab_, view.shot), view.shot);
    else if (check.against == "solution")
        view.expected = solution.shots[first + view.check].image;
    else
        view.against = first + size_t(&manifest_.check(check.against) - manifest_.checks.data());
}

void LabGrader::look_from_hidden_views(const CourseFiles& solution) {
    constexpr int attempts = 4;
    const size_t count = manifest_.checks.size();
    std::vector<View> best;
    for (int attempt = 0; attempt < attempts && best.size() < count; ++attempt) {
        const Variation variation(manifest_, lab_.folder, setup_.seed, attempt);
        std::vector<bool> wanted(2 * count);
        for (size_t i = 0; i < count; ++i)
            views_.push_back({i, variation.vary(manifest_.checks[i].shot)}), wanted[count + i] = true;
        const Attempt pictures = draw(solution, wanted);
        std::vector<bool> good(count);
        for (size_t i = 0; i < count; ++i) {
            try {
                expect(views_[count + i], pictures, count);
                good[i] = judge_view(count + i, pictures).outcome == Outcome::passed;
            } catch (const Error&) {  // no truth is known from there
            }
        }
        // Of two that are held against each other neither is right without the other, however long the chain.
        for (bool changed = true; changed;) {
            changed = false;
            for (size_t i = 0; i < count; ++i) {
                const size_t against = views_[count + i].against;
                if (!good[i] || against == 0 || good[against - count]) continue;
                good[i] = false, changed = true;
            }
        }
        std::vector<View> kept;
        std::vector<size_t> place(2 * count);
        for (size_t i = 0; i < count; ++i) {
            if (!good[i]) continue;
            place[count + i] = count + kept.size();
            kept.push_back(std::move(views_[count + i]));
        }
        for (View& view : kept)
            if (view.against > 0) view.against = place[view.against];
        views_.resize(count);
        if (kept.size() > best.size()) best = std::move(kept);
    }
    std::move(best.begin(), best.end(), std::back_inserter(views_));
}

LabGrader::~LabGrader() = default;

Attempt LabGrader::draw(const CourseFiles& files, const std::vector<bool>& wanted) const {
    Attempt pictures;
    pictures.shots.resize(views_.size());
    std::vector<size_t> which;
    std::vector<Shot> shots;
    size_t apart = 0;
    for (const bool secret : {false, true}) {
        if (secret) apart = which.size();
        for (size_t i = 0; i < wanted.size(); ++i)
            if (wanted[i] && is_secret(i) == secret) which.push_back(i), shots.push_back(views_[i].shot);
    }
    if (which.empty()) return pictures;
    Attempt drawn = attempt(stage_, lab_, files, shots, setup_.renderer, {setup_.seconds, setup_.memory}, apart);
    for (size_t i = 0; i < which.size(); ++i) pictures.shots[which[i]] = std::move(drawn.shots[i]);
    drawn.shots = std::move(pictures.shots);
    return drawn;
}

Judgement LabGrader::judge_view(size_t index, const Attempt& pictures) const {
    const View& view = views_[index];
    const CheckInfo& check = manifest_.checks[view.check];
    const auto failed = [](const DrawnAttempt& one) { return Judgement{one.outcome, one.error}; };
    const DrawnAttempt& drawn = pictures.shots[index];
    if (!drawn.image) return failed(drawn);
    if (view.expected) return judge(manifest_, check, *drawn.image, *view.expected);
    const DrawnAttempt& other = pictures.shots[view.against];
    if (!other.image) return failed(other);
    try {
        refuse_unusable(*other.image, views_[view.against].shot);
    } catch (const Error& error) {
        return {Outcome::broken, fmt::format("'{}': {}", check.against, error.what())};
    }
    return judge(manifest_, check, *drawn.image, *other.image);
}

CheckMark LabGrader::judge_check(size_t index, const Attempt& pictures, size_t& view) const {
    const CheckInfo& check = manifest_.checks[index];
    view = index;
    Judgement said = judge_view(index, pictures);
    for (size_t i = manifest_.checks.size(); i < views_.size() && said.outcome == Outcome::passed; ++i) {
        if (views_[i].check != index) continue;
        const Judgement hidden = judge_view(i, pictures);
        if (hidden.outcome == Outcome::passed) continue;
        view = i;
        said = {hidden.outcome, "right in the check's own view, not in a hidden one: " + hidden.found};
    }
    CheckMark mark{.name = check.name, .outcome = said.outcome, .found = said.found, .hidden = check.hidden};
    if (view != index) mark.view = view_text(views_[view].shot);
    return mark;
}

std::vector<bool> LabGrader::views_of(const std::vector<bool>& checks, bool with_hidden) const {
    std::vector<bool> wanted(views_.size());
    for (size_t i = 0; i < (with_hidden ? views_.size() : manifest_.checks.size()); ++i) {
        if (!checks[views_[i].check]) continue;
        wanted[i] = true;
        if (!views_[i].expected) wanted[views_[i].against] = true;
    }
    return wanted;
}

/// Whoever needs them first draws them; who comes meanwhile helps.
const std::vector<LabGrader::Signature>& LabGrader::signatures(const std::string& task) const {
    std::unique_lock lock(lazy_->mutex);
    Lazy::OfTask& known = lazy_->of_task[task];
    if (known.list.empty())
        for (const MistakeInfo& mistake : manifest_.mistakes)
            if (mistake.task == task && mistake.same_as.empty()) known.list.push_back({&mistake, {}});
    while (known.next < known.list.size()) {
        Signature& signature = known.list[known.next++];
        lock.unlock();
        signature.pictures = pictures_of(*signature.mistake);
        lock.lock();
        ++known.done;
        known.one_more.notify_all();
    }
    known.one_more.wait(lock, [&] { return known.done == known.list.size(); });
    return known.list;
}

std::map<size_t, LabGrader::Sampled> LabGrader::pictures_of(const MistakeInfo& mistake) const {
    CourseFiles files = edited(mistake.edits);
    for (const std::string& file : task_files(manifest_)) files.try_emplace(file, read_file(course_root() / file));
    std::vector<bool> checks;
    for (const CheckInfo& check : manifest_.checks) checks.push_back(check.task == mistake.task);
    const Attempt pictures = draw(files, views_of(checks, false));
    std::map<size_t, Sampled> result;
    for (size_t i = 0; i < manifest_.checks.size(); ++i)
        if (checks[i]) result[i] = Sampled(pictures.shots[i].image, pictures.shots[i].error);
    return result;
}

void LabGrader::name_mistake(TaskMark& task, const Attempt& pictures, const std::vector<bool>& compared) const {
    // Only what was drawn, or what the lab itself has complained of, can be like a mistake.
    bool any = false;
    for (size_t i = 0; i < manifest_.checks.size(); ++i) {
        const DrawnAttempt& one = pictures.shots[i];
        any |= manifest_.checks[i].task == task.id && compared[i] && one.told;
    }
    if (!any) return;
    double best = agreement;
    for (const Signature& signature : signatures(task.id)) {
        Likeness likeness;
        for (const auto& [check, picture] : signature.pictures)
            if (compared[check])
                compare(Sampled(pictures.shots[check].image, pictures.shots[check].error), picture,
                        lazy_->solution[check], bool(manifest_.checks[check].shot.probe), likeness);
        const double share = likeness.differ > 0 ? double(likeness.agree) / double(likeness.differ) : 0;
        if (share <= best) continue;
        best = share;
        task.mistake = signature.mistake->id, task.hint = signature.mistake->hint;
        for (const MistakeInfo& same : manifest_.mistakes)
            if (same.same_as == task.mistake) task.hint += " Or: " + same.hint;
    }
}

void LabGrader::keep_pictures(size_t index, const Attempt& pictures, std::vector<CheckPictures>& kept) const {
    const View& view = views_[index];
    const std::optional<Image>& drawn = pictures.shots[index].image;
    const std::optional<Image>& expected = view.expected ? view.expected : pictures.shots[view.against].image;
    if (!drawn || !expected || !drawn->same_shape(*expected)) return;
    CheckInfo check = manifest_.checks[view.check];
    check.shot = view.shot;
    kept.push_back({lab_.folder, &manifest_, std::move(check), index >= manifest_.checks.size(), *drawn, *expected});
}

LabMark LabGrader::mark(const Submission& submission, std::vector<CheckPictures>* kept, bool name_mistakes) const {
    LabMark lab{.lab = lab_.folder, .tasks = {}, .log = {}, .times = {}};
    // Why a task cannot be looked at, if so.
    std::map<std::string, Judgement> given_up;
    for (const TaskInfo& task : manifest_.tasks) {
        const auto file = submission.files.find(task.file);
        const auto refused = submission.refused.find(task.file);
        if (refused != submission.refused.end())
            given_up[task.id] = {Outcome::broken, fmt::format("{} is {}", task.file, refused->second)};
        else if (file == submission.files.end())
            given_up[task.id] = {Outcome::unfinished, fmt::format("there is no {}", task.file)};
        else if (const std::string more = foreign_include(task.file, file->second); !more.empty())
            given_up[task.id] = {Outcome::broken, fmt::format("{} includes {}, which is not part of this task",
                                                              task.file, printable(more))};
        else if (is_unfinished(file->second, task.id))
            given_up[task.id] = {Outcome::unfinished, "not written yet"};
    }
    const auto is_written = [&](const std::string& task) {
        const auto why = given_up.find(task);
        return why == given_up.end() || why->second.outcome != Outcome::unfinished;
    };
    std::vector<Judgement> said;  // by check
    std::vector<bool> looked_at;
    for (const CheckInfo& check : manifest_.checks) {
        const auto why = given_up.find(check.task);
        const std::string waits = waits_for(check, is_written);
        said.push_back(why != given_up.end() ? why->second : Judgement{Outcome::unfinished, waits});
        looked_at.push_back(why == given_up.end() && waits.empty());
    }
    CourseFiles files;
    for (const auto& [name, text] : submission.files)
        if (task_files(manifest_).contains(name)) files[name] = text;
    const Attempt pictures = draw(files, views_of(looked_at, true));
    lab.log = pictures.log, lab.times.compile = pictures.compile, lab.times.draw = pictures.draw;
    const auto begin = Clock::now();
    std::vector<CheckMark> marks;
    for (size_t i = 0; i < manifest_.checks.size(); ++i) {
        const CheckInfo& check = manifest_.checks[i];
        CheckMark& mark = marks.emplace_back(
            CheckMark{.name = check.name, .outcome = said[i].outcome, .found = said[i].found, .hidden = check.hidden});
        size_t view = i;
        if (looked_at[i]) mark = judge_check(i, pictures, view), said[i] = {mark.outcome, mark.found};
        if (kept && mark.outcome != Outcome::passed) keep_pictures(view, pictures, *kept);
    }
    const std::vector<std::string> all_hints = hints(manifest_, said);
    const std::vector<const CheckInfo*> first = put_right_first(manifest_, said);
    std::set<std::string> suspects;  // tasks with a failure that may be of their own
    for (size_t i = 0; i < said.size(); ++i) {
        if (first[i] || is_anothers(manifest_, said, i)) looked_at[i] = false;
        if (looked_at[i] && said[i].outcome != Outcome::passed) suspects.insert(manifest_.checks[i].task);
    }
    for (const TaskInfo& info : manifest_.tasks) {
        TaskMark& task = lab.tasks.emplace_back();
        task.id = info.id, task.title = info.title, task.file = info.file, task.of = info.points;
        size_t passed = 0;
        for (size_t i = 0; i < manifest_.checks.size(); ++i) {
            if (manifest_.checks[i].task != info.id) continue;
            marks[i].look_at = all_hints[i];
            passed += marks[i].outcome == Outcome::passed;
            task.checks.push_back(std::move(marks[i]));
        }
        if (task.checks.empty())
            throw Error(fmt::format("labs/{}/lab.toml: task {} has no check", lab_.folder, info.id));
        task.points = info.points * double(passed) / double(task.checks.size());
    }
    lab.times.compare = seconds_since(begin);
    for (TaskMark& task : lab.tasks)
        if (name_mistakes && suspects.contains(task.id) && lab.graded()) name_mistake(task, pictures, looked_at);
    return lab;
}

}  // namespace relief
