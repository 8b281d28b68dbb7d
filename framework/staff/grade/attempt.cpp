#include "framework/staff/grade/attempt.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "framework/staff/grade/submission.h"

namespace relief {
namespace {

/// Of what a compiler says, in bytes.
constexpr size_t longest_log = size_t{16} << 10;

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// The line of a compiler's output that says what is wrong.
std::string first_error(const std::string& output) {
    const size_t error = output.find("error:");
    const size_t begin = error == std::string::npos ? 0 : output.rfind('\n', error) + 1;
    return first_line(output.substr(begin));
}

/// What a process' ending says of the student's code in it.
Judgement blame(const ProcessResult& result, const std::string& problem) {
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
            return {Outcome::machine, printable(first_line(result.errors), 400)};
        case Ending::exited:
            break;
    }
    if (!problem.empty()) return {Outcome::broken, problem};
    const std::string said = result.errors.empty() ? "" : ": " + printable(first_line(result.errors));
    return {Outcome::crashed, fmt::format("the program ends in the middle, with exit code {}{}", result.code, said)};
}

/// What strangers' code or a compiler says of it, on a line.
std::string message(const std::string& text) { return printable(first_line(text), 400); }

/// Draws the shots from `from` to `end` by as many processes as it takes. `left`: seconds, for all of them.
void draw_staged(const Stage& stage, const LabEntry& lab, const StagedCourse& course, const std::vector<Shot>& shots,
                 size_t from, size_t end, const Renderer& renderer, const AttemptLimits& limits, double& left,
                 Attempt& attempt) {
    const bool own_program = course.program.parent_path() == course.folder->path();
    bool tried_again = false;
    while (from < end) {
        const auto fail_rest = [&](size_t begin, size_t last, const Judgement& why) {
            for (size_t i = begin; i < last; ++i)
                attempt.shots[i].outcome = why.outcome, attempt.shots[i].error = why.found;
        };
        if (left <= 0) return fail_rest(from, end, {Outcome::out_of_time, "the checks before it took all the time"});
        const std::vector<Shot> rest(shots.begin() + std::ptrdiff_t(from), shots.begin() + std::ptrdiff_t(end));
        ProcessJob job;
        job.command = {course.program.string(), "draw-checks", "--course", course.folder->path().string()};
        job.environment = {{"LC_ALL", "C.UTF-8"}, {"HOME", "/tmp"}, {"LD_LIBRARY_PATH", course.libraries.string()}};
        // In the sandbox's own memory, gone with it: the next shot need not compile the same shader again.
        if (stage.isolation() == Isolation::namespaces) job.environment["MESA_SHADER_CACHE_DIR"] = "/tmp/shaders";
        job.request = drawing_request(lab, rest, renderer), job.asks = drawing_asks();
        job.limits.wall = std::min(left, limits.seconds), job.limits.cpu = std::ceil(job.limits.wall);
        job.limits.memory = limits.memory, job.limits.output = drawings_size(rest);
        job.makes_processes = false;
        const ProcessResult result =
            run_sandboxed(job, {.isolation = stage.isolation(), .readable = course.readable, .processes = 32});
        DrawnShots drawn = read_drawings(result.output, rest);
        left -= result.wall, attempt.draw += result.wall;
        for (size_t i = 0; i < drawn.shots.size(); ++i) {
            DrawnAttempt& one = attempt.shots[from + i];
            one.image = std::move(drawn.shots[i].image), one.error = message(drawn.shots[i].error), one.told = true;
            if (drawn.shots[i].error != one.error && attempt.log.empty()) attempt.log = drawn.shots[i].error;
        }
        from += drawn.shots.size();
        if (drawn.done || from == end) return;
        const Judgement why = blame(result, drawn.problem);
        // Before there is a context none of a shader has run: then it is not the student's doing. A program of his own
        // may have done anything.
        if (why.outcome == Outcome::machine || (!drawn.ready && !own_program)) {
            if (!tried_again) {
                tried_again = true;
                continue;
            }
            return fail_rest(from, end, {Outcome::machine, "the machine failed: " + why.found});
        }
        if (!drawn.ready || !drawn.problem.empty()) return fail_rest(from, end, why);
        fail_rest(from, from + 1, why);
        ++from;
    }
}

}  // namespace

Attempt attempt(const Stage& stage, const LabEntry& lab, const CourseFiles& files, const std::vector<Shot>& shots,
                const Renderer& renderer, const AttemptLimits& limits, size_t apart) {
    Attempt result;
    result.shots.resize(shots.size());
    StagedCourse course = stage.course(lab, files);
    const Compiled compiled = stage.compile(lab, course, 3 * limits.seconds);
    result.compile = compiled.seconds;
    if (compiled.message.empty()) {
        double left = 2 * limits.seconds;
        // Shaders cannot tell what they were asked for; a program of a student's can.
        const bool own_program = course.program.parent_path() == course.folder->path();
        const size_t first = own_program ? std::min(apart, shots.size()) : shots.size();
        draw_staged(stage, lab, course, shots, 0, first, renderer, limits, left, result);
        const std::string log = result.log;
        draw_staged(stage, lab, course, shots, first, shots.size(), renderer, limits, left, result);
        result.log = printable_lines(log, longest_log);
        return result;
    }
    result.log = printable_lines(compiled.message, longest_log);
    for (DrawnAttempt& one : result.shots) {
        if (compiled.ending == Ending::failed) {
            one.outcome = Outcome::machine, one.error = "the machine failed: " + message(compiled.message);
            continue;
        }
        const ProcessResult ended{.ending = compiled.ending, .code = 1, .wall = compiled.seconds};
        const Judgement why = compiled.ending == Ending::exited
                                  ? Judgement{Outcome::broken, message(first_error(compiled.message))}
                                  : blame(ended, {});
        one.outcome = why.outcome;
        one.error = "it does not compile: " + (why.found.empty() ? message(compiled.message) : why.found);
    }
    return result;
}

}  // namespace relief
