#include "framework/staff/grade/attempt.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstring>

#include "framework/staff/grade/submission.h"

namespace relief::grade {
namespace {

/// Maximum length of a compiler's output that is kept, in bytes.
constexpr size_t longest_log = size_t{16} << 10;

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// Returns the first line with an error in a compiler's output; the first line at all if there is none.
std::string first_error(const std::string& output) {
    const size_t error = output.find("error:");
    const size_t begin = error == std::string::npos ? 0 : output.rfind('\n', error) + 1;
    return first_line(output.substr(begin));
}

/// Returns the verdict about the student's code after its process ended early.
check::Verdict blame(const ProcessResult& result, const std::string& problem) {
    switch (result.ending) {
        case Ending::out_of_time:
            if (result.stopped)
                return {check::Outcome::out_of_time, fmt::format("not finished after {:.0f} seconds", result.wall)};
            return {check::Outcome::out_of_time, "it needs more processor time than is allowed"};
        case Ending::out_of_memory:
            return {check::Outcome::out_of_memory, "it needs more memory than is allowed"};
        case Ending::crashed:
            if (result.code == SIGKILL)
                return {check::Outcome::crashed,
                        "the program was killed: it ended itself, or the system did because memory ran out"};
            return {check::Outcome::crashed,
                    fmt::format("the program ends with signal {} ({})", result.code, strsignal(result.code))};
        case Ending::too_much_output:
            return {check::Outcome::broken, "it prints too much"};
        case Ending::failed:
            return {check::Outcome::machine, printable(first_line(result.errors), 400)};
        case Ending::exited:
            break;
    }
    if (!problem.empty()) return {check::Outcome::broken, problem};
    const std::string said = result.errors.empty() ? "" : ": " + printable(first_line(result.errors));
    return {check::Outcome::crashed,
            fmt::format("the program ends in the middle, with exit code {}{}", result.code, said)};
}

/// Returns the first line of untrusted output, made printable.
std::string message(const std::string& text) { return printable(first_line(text), 400); }

/// Returns the job of a drawing process. Its output is not limited yet.
ProcessJob drawing_job(const Stage& stage, const StagedCourse& course, std::string request,
                       const AttemptLimits& limits) {
    ProcessJob job;
    job.command = {course.program.string(), "draw-checks", "--course", course.folder->path().string()};
    job.environment = {{"LC_ALL", "C.UTF-8"}, {"HOME", "/tmp"}, {"LD_LIBRARY_PATH", course.libraries.string()}};
    // Later shots of this process reuse compiled shaders. The cache lies in the sandbox's own memory and ends with it.
    // Entries from outside come with the request: there is no folder that two submissions can see.
    if (stage.isolation() != Isolation::limits) job.environment["MESA_SHADER_CACHE_DIR"] = "/tmp/shaders";
    job.request = std::move(request);
    job.asks = check::drawing_asks();
    job.limits.wall = limits.wall();
    job.limits.cpu = std::ceil(limits.cpu);
    job.limits.memory = limits.memory;
    return job;
}

Confinement drawing_confinement(const Stage& stage, const StagedCourse& course) {
    return {.isolation = stage.isolation(), .readable = course.readable, .processes = 32, .makes_processes = false};
}

/// Draws the shots of a staged course. Starts another process whenever one dies.
class StagedDrawing {
public:
    StagedDrawing(const Stage& stage, const LabEntry& lab, const StagedCourse& course, const std::vector<Shot>& shots,
                  const check::Renderer& renderer, const AttemptLimits& limits, const check::CompiledShaders& known,
                  bool keeps_compiled, Attempt& attempt)
        : stage_(stage),
          lab_(lab),
          course_(course),
          shots_(shots),
          renderer_(renderer),
          limits_(limits),
          known_(known),
          keeps_compiled_(keeps_compiled),
          attempt_(attempt),
          wall_left_(limits.wall()),
          cpu_left_(2 * limits.cpu) {}

    /// Returns whether the program contains a student's code.
    bool has_own_program() const { return course_.program.parent_path() == course_.folder->path(); }

    /// Draws the shots in [from, end). Each process that dies loses one shot.
    void draw(size_t from, size_t end) {
        bool tried_again = false;
        while (from < end) {
            if (ended_) return fail(from, end, *ended_);
            if (wall_left_ <= 0 || cpu_left_ <= 0)
                return fail(from, end, {check::Outcome::out_of_time, "the checks before it used up the time"});
            const std::vector<Shot> rest(shots_.begin() + std::ptrdiff_t(from), shots_.begin() + std::ptrdiff_t(end));
            const ProcessResult result = run_sandboxed(job(rest, end), drawing_confinement(stage_, course_));
            wall_left_ -= result.wall;
            attempt_.draw += result.wall;
            check::DrawnShots drawn = check::read_drawings(result.output, rest);
            attempt_.cpu += drawn.cpu;
            if (!drawn.compiled.empty()) attempt_.compiled = std::move(drawn.compiled);
            // A dead process cannot report its processor time; both values are upper bounds of it.
            cpu_left_ -= std::min(result.wall, limits_.cpu);
            for (check::Drawn& shot : drawn.shots) keep(std::move(shot), attempt_.shots[from++]);
            if (drawn.phase == check::DrawingPhase::done || from == end) return;
            check::Verdict why = blame(result, drawn.problem);
            if (drawn.has_no_memory) why = blame({.ending = Ending::out_of_memory}, {});
            const bool has_context = drawn.phase == check::DrawingPhase::ready;
            // No student's shader runs before there is a context. So the machine is to blame, unless the program itself
            // contains a student's code.
            const bool is_machines = why.outcome == check::Outcome::machine || (!has_context && !has_own_program());
            if (is_machines && tried_again)
                return fail(from, end, {check::Outcome::machine, "the machine failed: " + why.found});
            if (is_machines) {
                tried_again = true;
                continue;
            }
            // The grader waits for an endless loop only once, not in every check.
            if (why.outcome == check::Outcome::out_of_time)
                ended_ = {why.outcome, "not drawn, since a check before it is out of time: " + why.found};
            if (!has_context || !drawn.problem.empty()) return fail(from, end, why);
            attempt_.shots[from].ran_out = why.outcome == check::Outcome::out_of_time;
            fail(from, from + 1, why);
            ++from;
        }
    }

private:
    /// Returns the job for `shots`, which end at index `end`.
    ProcessJob job(const std::vector<Shot>& shots, size_t end) const {
        const check::ShaderReuse reuse{.known = attempt_.compiled.empty() ? known_ : attempt_.compiled,
                                       .returns = keeps_compiled_ || end < shots_.size()};
        ProcessJob job = drawing_job(stage_, course_, check::drawing_request(lab_, shots, renderer_, reuse), limits_);
        job.limits.wall = wall_left_;
        job.limits.cpu = std::ceil(std::min(cpu_left_, limits_.cpu));
        job.limits.output = check::drawings_size(shots);
        return job;
    }

    void keep(check::Drawn shot, DrawnAttempt& place) {
        place.image = std::move(shot.image);
        place.error = message(shot.error);
        place.told = true;
        place.cpu = shot.cpu;
        if (shot.error != place.error && attempt_.log.empty()) attempt_.log = shot.error;
    }

    void fail(size_t begin, size_t end, const check::Verdict& why) {
        for (size_t i = begin; i < end; ++i) {
            attempt_.shots[i].outcome = why.outcome;
            attempt_.shots[i].error = why.found;
        }
    }

    const Stage& stage_;
    const LabEntry& lab_;
    const StagedCourse& course_;
    const std::vector<Shot>& shots_;
    const check::Renderer& renderer_;
    const AttemptLimits& limits_;
    const check::CompiledShaders& known_;
    bool keeps_compiled_;
    Attempt& attempt_;
    double wall_left_, cpu_left_;          ///< seconds
    std::optional<check::Verdict> ended_;  ///< why no more shots are drawn
};

/// Returns the verdict about a C++ task whose compilation failed.
check::Verdict blame(const Compiled& compiled) {
    if (compiled.ending == Ending::failed)
        return {check::Outcome::machine, "the machine failed: " + message(compiled.message)};
    check::Verdict why{check::Outcome::broken, message(first_error(compiled.message))};
    if (compiled.ending != Ending::exited)
        why = blame({.ending = compiled.ending, .code = 1, .wall = compiled.seconds, .stopped = compiled.stopped}, {});
    if (why.found.empty()) why.found = message(compiled.message);
    return {why.outcome, "it does not compile: " + why.found};
}

}  // namespace

Attempt attempt(const Stage& stage, const LabEntry& lab, const CourseFiles& files, const std::vector<Shot>& shots,
                const check::Renderer& renderer, const AttemptLimits& limits, size_t apart,
                const check::CompiledShaders& known, bool keeps_compiled, const std::string& alone) {
    Attempt result;
    result.shots.resize(shots.size());
    StagedCourse course = stage.course(lab, files, alone);
    const Compiled compiled = stage.compile(lab, course, limits.compile_cpu(), limits.wall());
    result.compile = compiled.seconds;
    if (!compiled.message.empty()) {
        const check::Verdict why = blame(compiled);
        for (DrawnAttempt& one : result.shots) {
            one.outcome = why.outcome;
            one.error = why.found;
        }
        result.log = printable_lines(compiled.message, longest_log);
        result.compiles_forever =
            why.outcome == check::Outcome::out_of_time || why.outcome == check::Outcome::out_of_memory;
        result.wasted = result.compiles_forever ? compiled.seconds / limits.wall() : 0;
        return result;
    }
    StagedDrawing drawing(stage, lab, course, shots, renderer, limits, known, keeps_compiled, result);
    // A shader cannot reveal which shots were requested; a student's program can.
    const size_t first = drawing.has_own_program() ? std::min(apart, shots.size()) : shots.size();
    drawing.draw(0, first);
    result.log = printable_lines(result.log, longest_log);
    const std::string log = result.log;
    drawing.draw(first, shots.size());
    result.log = log;
    if (std::any_of(result.shots.begin(), result.shots.end(),
                    [](const DrawnAttempt& one) { return !one.image && one.outcome == check::Outcome::out_of_time; }))
        result.wasted = (result.compile + result.draw) / limits.wall();
    if (!keeps_compiled) result.compiled.clear();
    return result;
}

check::NotedCalls note_calls(const Stage& stage, const LabEntry& lab, const CourseFiles& files,
                             const std::vector<check::NotedShot>& shots, const check::Renderer& renderer,
                             const AttemptLimits& limits) {
    StagedCourse course = stage.course(lab, files);
    if (!stage.compile(lab, course, limits.compile_cpu(), limits.wall()).message.empty())
        return check::NotedCalls(shots.size());
    std::set<std::string> shaders;
    for (const auto& [file, text] : files)
        if (is_shader(file)) shaders.insert(file);
    ProcessJob job = drawing_job(stage, course, check::noting_request(lab, shaders, shots, renderer), limits);
    job.limits.output = check::notes_size(shots);
    return check::read_notes(run_sandboxed(job, drawing_confinement(stage, course)).output, shots);
}

}  // namespace relief::grade
