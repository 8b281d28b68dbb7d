// Errors with a place: the problem, its file and line, and how to fix it.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace relief {

/// The place of an error. `line` counts from 1; 0 means the whole file.
struct Place {
    std::filesystem::path file;
    int line = 0;
};

/// A failed set-up. `what()` is one line, "file:line: message", and tells a person how to fix it. The process ends with
/// exit code 1.
class Error : public std::runtime_error {
public:
    explicit Error(const std::string& message);
    Error(const Place& place, const std::string& message, std::string details = {});

    const Place& place() const { return place_; }
    /// Text that does not fit on one line, such as a compiler's log; or empty.
    const std::string& details() const { return details_; }

private:
    Place place_;
    std::string details_;
};

/// The user asked for something that does not exist or is out of range. The process ends with exit code 2.
class UsageError : public Error {
public:
    using Error::Error;
};

}  // namespace relief
