// Errors with a place: what is wrong, in which file and line, and what would be right.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace relief {

/// Where something went wrong. `line` counts from 1; 0 means the whole file.
struct Place {
    std::filesystem::path file;
    int line = 0;
};

/// Set-up failed. `what()` is one line, "file:line: message", and tells a person what to do.
/// The process ends with exit code 1.
class Error : public std::runtime_error {
public:
    explicit Error(const std::string& message);
    Error(const Place& place, const std::string& message, std::string details = {});

    const Place& place() const { return place_; }
    /// More than fits on one line (a compiler's whole log), or empty.
    const std::string& details() const { return details_; }
    /// The details without their first line, if that is what() again.
    std::string more_details() const;

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
