#include "framework/course/check/printed.h"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>

namespace relief::check {
namespace {

/// Returns the text behind `begin`; nothing if `line` does not contain it.
std::optional<std::string> behind(const std::string& line, std::string_view begin) {
    const size_t at = line.find(begin);
    return at == std::string::npos ? std::nullopt : std::optional(line.substr(at + begin.size()));
}

/// Returns "labs/05_tangent_basis/task.cpp:32" from a line that names a task's source and a line of it.
std::optional<std::string> place_in(const std::string& line) {
    constexpr std::string_view name = "/task.cpp:";
    const size_t at = line.find(name);
    if (at == std::string::npos) return {};
    const size_t folder = line.rfind("labs/", at);
    const size_t end = line.find_first_not_of("0123456789", at + name.size());
    if (folder == std::string::npos || end == at + name.size()) return {};
    return line.substr(folder, end == std::string::npos ? end : end - folder);
}

/// Returns the sentence for the name by which the address sanitizer calls a fault.
std::string fault_named(const std::string& name) {
    using Words = std::pair<std::string_view, const char*>;
    static constexpr std::array words = {
        Words{"heap-buffer-overflow", "reads or writes outside of an array"},
        Words{"stack-buffer-overflow", "reads or writes outside of an array"},
        Words{"global-buffer-overflow", "reads or writes outside of an array"},
        Words{"dynamic-stack-buffer-overflow", "reads or writes outside of an array"},
        Words{"heap-use-after-free", "uses memory that was freed"},
        Words{"stack-use-after-scope", "uses a variable after its block has ended"},
        Words{"stack-use-after-return", "uses a variable after its function has returned"},
        Words{"stack-overflow", "has no stack left: does a function call itself without end?"},
        Words{"attempting double-free", "frees memory twice"},
        Words{"SEGV", "reads or writes at an address that is not its own"},
        Words{"FPE", "divides an integer by zero"},
        Words{"allocation-size-too-big", "asks for too much memory"},
        Words{"requested allocation size", "asks for too much memory"},
        Words{"out of memory", "asks for too much memory"},
    };
    for (const auto& [begin, sentence] : words)
        if (name.starts_with(begin)) return sentence;
    return name.substr(0, name.find(" on "));
}

}  // namespace

Printed read_printed(const std::string& text) {
    Printed result;
    std::istringstream lines(text);
    bool is_report = false;
    for (std::string line; std::getline(lines, line);) {
        const bool had_fault = !result.fault.empty();
        if (const auto said = behind(line, ": runtime error: ")) {
            is_report = true;
            if (!had_fault) result.fault = *said;
        } else if (const auto assertion = behind(line, "Assertion '"); assertion && line.find(".h:") != line.npos) {
            is_report = true;
            if (!had_fault)
                result.fault = fmt::format("violates what the C++ library demands: {}",
                                           assertion->substr(0, assertion->find("' failed")));
        } else if (const auto name = behind(line, "ERROR: AddressSanitizer: ")) {
            is_report = true;
            // An assertion, or the end of the time, ends the process by SIGABRT.
            if (!had_fault && !name->starts_with("ABRT")) result.fault = fault_named(*name);
            if (line.find("points to the zero page") != line.npos) result.fault = "uses a null pointer";
        } else if (behind(line, "Hint: address points to the zero page")) {
            result.fault = "uses a null pointer";
        } else if (behind(line, "rss limit exhausted")) {
            is_report = true;
            result.fault = "needs too much memory", result.has_no_memory = true;
        } else if (line.starts_with("AddressSanitizer:DEADLYSIGNAL") || line.starts_with("==========")) {
            is_report = true;
        }
        if (!is_report) {
            result.text += line + "\n";
            continue;
        }
        if (const auto place = place_in(line); place && result.place.empty()) result.place = *place;
    }
    if (!text.empty() && text.back() != '\n' && !is_report) result.text.pop_back();
    result.has_no_memory |= result.fault == "asks for too much memory";
    return result;
}

}  // namespace relief::check
