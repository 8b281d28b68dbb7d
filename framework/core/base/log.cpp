#include "framework/core/base/log.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "framework/core/base/system.h"

namespace relief {
namespace {

bool tells_events = false;
double milliseconds_before = 0;  // run time of the process before `watch` started
Stopwatch watch;

bool colour() {
    static const bool on = os::is_terminal(standard_error) && !std::getenv("NO_COLOR");
    return on;
}

/// Ignores errors: the reader of standard error may be gone, and there is no other place to report it.
void say(const std::string& text) {
    if (std::fwrite(text.data(), 1, text.size(), stderr) == text.size()) std::fflush(stderr);
}

}  // namespace

void print_error(std::string_view message) {
    say(fmt::format(fmt::runtime(colour() ? "\x1b[31mrelief:\x1b[0m {}\n" : "relief: {}\n"), message));
}

void print_note(std::string_view message) { say(fmt::format("relief: {}\n", message)); }

std::string note_about(const Place& place, const std::string& message) {
    return Error({place.file.filename(), place.line}, message).what();
}

void set_verbose(bool on) {
    tells_events = on;
    // The system knows the start of the process only to a hundredth of a second. But until now the process had one
    // thread, which never waited, so its processor time is its run time.
    watch = {};
    milliseconds_before = 1e3 * double(std::clock()) / CLOCKS_PER_SEC;
}

bool is_verbose() { return tells_events; }

void print_event(std::string_view message) {
    if (tells_events) say(fmt::format("[{:7.1f} ms] {}\n", milliseconds_before + watch.milliseconds(), message));
}

void Progress::next(std::string_view what) {
    const int done = begun_++;
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin_;
    if (!os::is_terminal(standard_error) || passed < std::chrono::seconds(2)) return;
    constexpr int width = 20;
    const int full = std::clamp(done * width / std::max(total_, 1), 0, width);
    const double left = done > 0 ? passed.count() / done * (total_ - done) : 0;
    const std::string time = done == 0     ? ""
                             : left < 90   ? fmt::format(", {:.0f} s left", left)
                             : left < 5400 ? fmt::format(", {:.0f} min left", left / 60)
                                           : fmt::format(", {:.1f} h left", left / 3600);
    say(fmt::format("\r\x1b[K[{:<{}}] {} of {}{}: {}", std::string(size_t(full), '#'), width, begun_, total_, time,
                    what));
    shown_ = true;
}

Progress::~Progress() {
    if (shown_) say("\r\x1b[K");
}

}  // namespace relief
