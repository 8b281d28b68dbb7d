#include "framework/core/base/error.h"

#include <algorithm>
#include <utility>

#include "framework/core/base/paths.h"

namespace relief {
namespace {

std::string one_line(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    while (!text.empty() && text.back() == ' ') text.pop_back();
    return text;
}

std::string with_place(const Place& place, const std::string& message) {
    std::string start = place.file.empty() ? "" : shown(place.file);
    if (place.line > 0) start += ":" + std::to_string(place.line);
    return one_line(start.empty() ? message : start + ": " + message);
}

}  // namespace

Error::Error(const std::string& message) : std::runtime_error(one_line(message)) {}

Error::Error(const Place& place, const std::string& message, std::string details)
    : std::runtime_error(with_place(place, message)), place_(place), details_(std::move(details)) {}

}  // namespace relief
