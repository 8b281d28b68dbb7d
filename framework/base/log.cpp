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

}  // namespace

void print_error(std::string_view message) {
    if (colour())
        fmt::print(stderr, "\x1b[31mrelief:\x1b[0m {}\n", message);
    else
        fmt::print(stderr, "relief: {}\n", message);
}

void print_note(std::string_view message) { fmt::print(stderr, "relief: {}\n", message); }

void set_verbose(bool on) { is_verbose = on; }
bool verbose() { return is_verbose; }

void print_event(std::string_view message) {
    if (is_verbose) fmt::print(stderr, "{}\n", message);
}

void Progress::next(std::string_view what) {
    ++done_;
    if (!isatty(STDERR_FILENO) || std::chrono::steady_clock::now() - begin_ < std::chrono::seconds(2)) return;
    fmt::print(stderr, "\r\x1b[K{} of {}: {}", done_, total_, what);
    std::fflush(stderr);
    shown_ = true;
}

Progress::~Progress() {
    if (shown_) fmt::print(stderr, "\r\x1b[K");
}

}  // namespace relief
