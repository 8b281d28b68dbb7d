// Messages on standard error, one line each. Colour is used on a terminal only. A progress bar appears when a run takes
// longer than two seconds.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

#include "framework/core/base/error.h"

namespace relief {

/// Prints "relief: message", red on a terminal.
void print_error(std::string_view message);

/// Prints "relief: message": information that is useful to a person and not needed by a script.
void print_note(std::string_view message);

/// Returns a line about a user's file, for print_note() and for pictures: "name:line: message". The name has no
/// folders, because a picture has little room.
std::string note_about(const Place& place, const std::string& message);

/// Prints an event of the run: "[  12.3 ms] message", with the time since the process began. Prints nothing unless
/// set_verbose(true) was called, as --verbose does.
void set_verbose(bool on);
bool is_verbose();
void print_event(std::string_view message);

/// Measures the time since its construction.
class Stopwatch {
public:
    double milliseconds() const {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin_).count();
    }

private:
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

/// Shows "[###       ] 3 of 17, 20 s left: lab 03" on a terminal's last line after two seconds. Shows nothing when
/// standard error is not a terminal. The destructor removes the line.
class Progress {
public:
    explicit Progress(int total) : total_(total) {}
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Begins the next part, named `what`.
    void next(std::string_view what);

private:
    int total_, begun_ = 0;
    bool shown_ = false;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace relief
