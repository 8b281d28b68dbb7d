// What a run says on standard error: one line a message, colour only on a terminal, and what it is doing when
// that takes longer than two seconds.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace relief {

/// "relief: message", red on a terminal.
void print_error(std::string_view message);

/// "relief: message". For what a person should know and a script need not.
void print_note(std::string_view message);

/// Event by event, what the run does: "[  12.3 ms] message", by the time since the process began. Printed with
/// --verbose only.
void set_verbose(bool on);
void print_event(std::string_view message);

/// Time since it was made.
class Stopwatch {
public:
    double milliseconds() const {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin_).count();
    }

private:
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

/// "[###       ] 3 of 17, 20 s left: lab 03" on a terminal's last line, from the third second on; nothing when standard
/// error is not a terminal. The line is gone when the object is.
class Progress {
public:
    explicit Progress(int total) : total_(total) {}
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Call before each part with its name.
    void next(std::string_view what);

private:
    int total_, begun_ = 0;
    bool shown_ = false;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace relief
