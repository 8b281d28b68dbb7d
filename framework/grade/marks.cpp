#include "framework/grade/marks.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstring>
#include <mutex>

#include "framework/base/error.h"
#include "framework/base/file.h"
#include "framework/base/paths.h"
#include "framework/gl/shader_source.h"
#include "framework/grade/starter.h"
#include "framework/grade/variation.h"

namespace relief {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// What a submission's shader includes and the course's own does not: other files may know answers. Else empty.
std::string foreign_include(const std::string& file, const std::string& text) {
    if (!file.ends_with(".glsl")) return {};
    const std::set<std::string> own = included_by(read_file(course_root() / file));
    for (const std::string& name : included_by(text))
        if (!own.contains(name)) return name;
    return {};
}

/// The line of a compiler's output that says what is wrong.
std::string first_error(const std::string& output) {
    const size_t error = output.find("error:");
    const size_t begin = error == std::string::npos ? 0 : output.rfind('\n', error) + 1;
    return first_line(output.substr(begin));
}

/// What a process' ending says of the student's code in it.
Judgement blame(const SandboxResult& result, const std::string& problem) {
    switch (result.ending) {
        case Ending::out_of_time:
            return {Outcome::out_of_time, fmt::format("not done after {:.0f} seconds", result.wall)};
        case Ending::out_of_memory:
            return {Outcome::out_of_memory, "it asks for more memory than there is"};
        case Ending::crashed:
            return {Outcome::crashed,
                    fmt::format("the program ends with signal {} ({})", result.code, strsignal(result.code))};
        case Ending::too_much_output:
            return {Outcome::broken, "it prints without end"};
        case Ending::failed:
            return {Outcome::machine, first_line(result.errors)};
        case Ending::exited:
            break;
    }
    if (!problem.empty()) return {Outcome::broken, problem};
    const std::string said = result.errors.empty() ? "" : ": " + printable(first_line(result.errors));
    return {Outcome::crashed, fmt::format("the program ends in the middle, with exit code {}{}", result.code, said)};
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

/// What came of each check's shot.
struct LabGrader::Pictures {
    struct One {
        std::optional<Image> image;
        Outcome outcome = Outcome::broken;  ///< where there is no image
        std::string error;
        bool told = false;  ///< the error came from the lab as it drew
    };
    std::vector<One> of;  ///< by check
    double compile = 0, draw = 0;
    std::string log;
};

/// Some pixels of a picture, evenly spread, or the failure that came in its place.
struct LabGrader::Sampled {
    std::vector<float> values;
    std::string error;
    bool drawn = false;

    Sampled() = default;
    Sampled(const std::optional<Image>& image, const std::string& failure);
};

LabGrader::Sampled::Sampled(const std::optional<Image>& image, const std::string& failure)
    : error(first_line(failure)), drawn(image.has_value()) {
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
int LabMark::of() const {
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
    const Pictures pictures = draw(solution, std::vector<bool>(views_.size(), true));
    for (size_t i = 0; i < views_.size(); ++i) {
        lazy_->solution.push_back(Sampled(pictures.of[i].image, pictures.of[i].error));
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
void LabGrader::expect(View& view, const Pictures& solution, size_t first) const {
    const CheckInfo& check = manifest_.checks[view.check];
    if (check.against == "truth")
        view.expected = truth_of(*make_lab(lab_, view.shot), view.shot);
    else if (check.against == "solution")
        view.expected = solution.of[first + view.check].image;
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
            views_.push_back({i, variation.of(manifest_.checks[i].shot)}), wanted[count + i] = true;
        const Pictures pictures = draw(solution, wanted);
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

LabGrader::Pictures LabGrader::draw(const CourseFiles& files, const std::vector<bool>& wanted) const {
    Pictures pictures;
    pictures.of.resize(views_.size());
    std::vector<size_t> which;
    for (size_t i = 0; i < wanted.size(); ++i)
        if (wanted[i]) which.push_back(i);
    if (which.empty()) return pictures;
    StagedCourse course = stage_.course(lab_, files);
    const Compiled compiled = stage_.compile(lab_, course, 3 * setup_.seconds);
    pictures.compile = compiled.seconds;
    if (compiled.message.empty()) {
        draw_on(course, pictures, which);
        return pictures;
    }
    pictures.log = compiled.message;
    const SandboxResult ended{
        .ending = compiled.ending, .code = 1, .output = {}, .errors = {}, .wall = compiled.seconds};
    const Judgement why = compiled.ending == Ending::exited ? Judgement{Outcome::broken, first_error(compiled.message)}
                                                            : blame(ended, {});
    for (const size_t i : which) {
        pictures.of[i].outcome = why.outcome;
        pictures.of[i].error = "it does not compile: " + (why.found.empty() ? compiled.message : why.found);
    }
    return pictures;
}

void LabGrader::draw_on(const StagedCourse& course, Pictures& pictures, const std::vector<size_t>& which) const {
    const bool own_program = course.program.parent_path() == course.folder->path();
    double left = 2 * setup_.seconds;
    bool tried_again = false;
    for (size_t from = 0; from < which.size();) {
        const auto fail_rest = [&](size_t begin, size_t end, const Judgement& why) {
            for (size_t i = begin; i < end; ++i)
                pictures.of[which[i]].outcome = why.outcome, pictures.of[which[i]].error = why.found;
        };
        if (left <= 0)
            return fail_rest(from, which.size(), {Outcome::out_of_time, "the checks before it took all the time"});
        std::vector<Shot> shots;
        for (size_t i = from; i < which.size(); ++i) shots.push_back(views_[which[i]].shot);
        SandboxJob job;
        job.command = {course.program.string(), "draw-checks", "--course", course.folder->path().string()};
        job.readable = course.readable;
        job.environment = {{"LC_ALL", "C.UTF-8"}, {"HOME", "/tmp"}, {"LD_LIBRARY_PATH", course.libraries.string()}};
        // In the sandbox's own memory, gone with it: the next shot need not compile the same shader again.
        if (setup_.isolation == Isolation::namespaces) job.environment["MESA_SHADER_CACHE_DIR"] = "/tmp/shaders";
        job.input = drawing_request(lab_, shots, setup_.renderer);
        job.limits.wall = std::min(left, setup_.seconds), job.limits.cpu = std::ceil(job.limits.wall);
        job.limits.memory = setup_.memory, job.limits.output = drawings_size(shots);
        job.limits.processes = 32;
        const SandboxResult result = run_sandboxed(job, setup_.isolation);
        DrawnShots drawn = read_drawings(result.output, shots);
        left -= result.wall, pictures.draw += result.wall;
        for (size_t i = 0; i < drawn.shots.size(); ++i) {
            Pictures::One& one = pictures.of[which[from + i]];
            one.image = std::move(drawn.shots[i].image), one.error = first_line(drawn.shots[i].error), one.told = true;
            // A program of the student's may say what it likes, to him as well: let it be short.
            if (own_program) one.error = printable(one.error);
            if (drawn.shots[i].error != one.error && pictures.log.empty()) pictures.log = drawn.shots[i].error;
        }
        from += drawn.shots.size();
        if (drawn.done || from == which.size()) return;
        const Judgement why = blame(result, drawn.problem);
        // Before there is a context none of a shader has run: then it is not the student's doing. A program of his own
        // may have done anything.
        if (why.outcome == Outcome::machine || (!drawn.ready && !own_program)) {
            if (!tried_again) {
                tried_again = true;
                continue;
            }
            return fail_rest(from, which.size(), {Outcome::machine, "the machine failed: " + why.found});
        }
        if (!drawn.ready || !drawn.problem.empty()) return fail_rest(from, which.size(), why);
        fail_rest(from, from + 1, why);
        ++from;
    }
}

Judgement LabGrader::judge_view(size_t index, const Pictures& pictures) const {
    const View& view = views_[index];
    const CheckInfo& check = manifest_.checks[view.check];
    const auto failed = [](const Pictures::One& one) { return Judgement{one.outcome, one.error}; };
    const Pictures::One& drawn = pictures.of[index];
    if (!drawn.image) return failed(drawn);
    if (view.expected) return judge(manifest_, check, *drawn.image, *view.expected);
    const Pictures::One& other = pictures.of[view.against];
    if (!other.image) return failed(other);
    try {
        refuse_unusable(*other.image, views_[view.against].shot);
    } catch (const Error& error) {
        return {Outcome::broken, fmt::format("'{}': {}", check.against, error.what())};
    }
    return judge(manifest_, check, *drawn.image, *other.image);
}

CheckMark LabGrader::judge_check(size_t index, const Pictures& pictures, size_t& view) const {
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
    if (mark.outcome == Outcome::wrong) mark.look_at = check.look_at;
    if (view != index) mark.view = view_text(views_[view].shot);
    return mark;
}

std::vector<bool> LabGrader::views_of(const std::set<std::string>& tasks, bool with_hidden) const {
    std::vector<bool> wanted(views_.size());
    for (size_t i = 0; i < (with_hidden ? views_.size() : manifest_.checks.size()); ++i) {
        if (!tasks.contains(manifest_.checks[views_[i].check].task)) continue;
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
    const std::vector<bool> wanted = views_of({mistake.task}, false);
    const Pictures pictures = draw(files, wanted);
    std::map<size_t, Sampled> result;
    for (size_t i = 0; i < manifest_.checks.size(); ++i)
        if (wanted[i] && manifest_.checks[i].task == mistake.task)
            result[i] = Sampled(pictures.of[i].image, pictures.of[i].error);
    return result;
}

void LabGrader::name_mistake(TaskMark& task, const Pictures& pictures) const {
    // Only what was drawn, or what the lab itself has complained of, can be like a mistake.
    bool any = false;
    for (size_t i = 0; i < manifest_.checks.size(); ++i) {
        const Pictures::One& one = pictures.of[i];
        any |= manifest_.checks[i].task == task.id && one.told;
    }
    if (!any) return;
    double best = agreement;
    for (const Signature& signature : signatures(task.id)) {
        Likeness likeness;
        for (const auto& [check, picture] : signature.pictures)
            compare(Sampled(pictures.of[check].image, pictures.of[check].error), picture, lazy_->solution[check],
                    bool(manifest_.checks[check].shot.probe), likeness);
        const double share = likeness.differ > 0 ? double(likeness.agree) / double(likeness.differ) : 0;
        if (share <= best) continue;
        best = share;
        task.mistake = signature.mistake->id, task.hint = signature.mistake->hint;
        for (const MistakeInfo& same : manifest_.mistakes)
            if (same.same_as == task.mistake) task.hint += " Or: " + same.hint;
    }
}

void LabGrader::keep_pictures(size_t index, const Pictures& pictures, std::vector<CheckPictures>& kept) const {
    const View& view = views_[index];
    const std::optional<Image>& drawn = pictures.of[index].image;
    const std::optional<Image>& expected = view.expected ? view.expected : pictures.of[view.against].image;
    if (!drawn || !expected || !drawn->same_shape(*expected)) return;
    CheckInfo check = manifest_.checks[view.check];
    check.shot = view.shot;
    kept.push_back({lab_.folder, &manifest_, std::move(check), index >= manifest_.checks.size(), *drawn, *expected});
}

LabMark LabGrader::mark(const Submission& submission, std::vector<CheckPictures>* kept, bool name_mistakes) const {
    LabMark lab{.lab = lab_.folder, .tasks = {}, .log = {}, .times = {}};
    // Why a task cannot be looked at, if so.
    std::map<std::string, Judgement> given_up;
    std::set<std::string> tasks;
    for (const TaskInfo& task : manifest_.tasks) {
        const auto file = submission.files.find(task.file);
        const auto refused = submission.refused.find(task.file);
        if (refused != submission.refused.end())
            given_up[task.id] = {Outcome::broken, fmt::format("{} is {}", task.file, refused->second)};
        else if (file == submission.files.end())
            given_up[task.id] = {Outcome::unfinished, fmt::format("there is no {}", task.file)};
        else if (const std::string more = foreign_include(task.file, file->second); !more.empty())
            given_up[task.id] = {Outcome::broken,
                                 fmt::format("{} includes {}, which is not part of this task", task.file, more)};
        else if (is_unfinished(file->second, task.id))
            given_up[task.id] = {Outcome::unfinished, "not written yet"};
        else
            tasks.insert(task.id);
    }
    CourseFiles files;
    for (const auto& [name, text] : submission.files)
        if (task_files(manifest_).contains(name)) files[name] = text;
    const Pictures pictures = draw(files, views_of(tasks, true));
    lab.log = pictures.log, lab.times.compile = pictures.compile, lab.times.draw = pictures.draw;
    const auto begin = Clock::now();
    for (const TaskInfo& info : manifest_.tasks) {
        TaskMark& task = lab.tasks.emplace_back();
        task.id = info.id, task.title = info.title, task.file = info.file, task.of = info.points;
        size_t passed = 0;
        for (size_t i = 0; i < manifest_.checks.size(); ++i) {
            const CheckInfo& check = manifest_.checks[i];
            if (check.task != info.id) continue;
            size_t view = i;
            CheckMark mark{
                .name = check.name, .outcome = Outcome::unfinished, .found = {}, .look_at = {}, .hidden = check.hidden};
            if (const auto why = given_up.find(info.id); why != given_up.end())
                mark.outcome = why->second.outcome, mark.found = why->second.found;
            else
                mark = judge_check(i, pictures, view);
            passed += mark.outcome == Outcome::passed;
            if (kept && mark.outcome != Outcome::passed) keep_pictures(view, pictures, *kept);
            task.checks.push_back(std::move(mark));
        }
        if (task.checks.empty())
            throw Error(fmt::format("labs/{}/lab.toml: task {} has no check", lab_.folder, info.id));
        task.points = info.points * double(passed) / double(task.checks.size());
    }
    lab.times.compare = seconds_since(begin);
    for (TaskMark& task : lab.tasks)
        if (name_mistakes && task.points < task.of && tasks.contains(task.id) && lab.graded())
            name_mistake(task, pictures);
    return lab;
}

}  // namespace relief
