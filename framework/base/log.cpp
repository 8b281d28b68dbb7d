#include "framework/base/log.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

namespace relief {
namespace {

bool is_verbose = false;

bool colour() {
    static const bool on = isatty(STDERR_FILENO) && !std::getenv("NO_COLOR");
    return on;
}

/// Whoever reads standard error may be gone: nothing can be said about that, and nothing is thrown.
void say(const std::string& text) {
    if (std::fwrite(text.data(), 1, text.size(), stderr) == text.size()) std::fflush(stderr);
}

}  // namespace

void print_error(std::string_view message) {
    say(fmt::format(fmt::runtime(colour() ? "\x1b[31mrelief:\x1b[0m {}\n" : "relief: {}\n"), message));
}

void print_note(std::string_view message) { say(fmt::format("relief: {}\n", message)); }

void set_verbose(bool on) { is_verbose = on; }

void print_event(std::string_view message) {
    if (is_verbose) say(fmt::format("{}\n", message));
}

void Progress::next(std::string_view what) {
    ++done_;
    if (!isatty(STDERR_FILENO) || std::chrono::steady_clock::now() - begin_ < std::chrono::seconds(2)) return;
    say(fmt::format("\r\x1b[K{} of {}: {}", done_, total_, what));
    shown_ = true;
}

Progress::~Progress() {
    if (shown_) say("\r\x1b[K");
}

}  // namespace relief
