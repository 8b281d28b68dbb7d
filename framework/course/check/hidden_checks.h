// The hidden checks of a task: they decide points when it is graded, and a student's course has only their number.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "framework/course/manifest/manifest.h"

namespace relief {
struct LabEntry;
}

namespace relief::check {

/// The hidden checks of a task: their number, and the words of the task's text that no public call tests.
struct HiddenChecks {
    int count = 0;
    std::vector<std::string> not_tested = {};
};
using HiddenByTask = std::map<std::string, HiddenChecks>;

/// Returns the tasks of a manifest that have hidden checks. Empty for a student's manifest.
HiddenByTask hidden_checks(const Manifest& manifest);

/// Reads the file that a handout has written into the lab's folder; empty if there is none, as in the staff's course,
/// or if it is damaged.
HiddenByTask read_hidden_checks(const LabEntry& lab);
std::filesystem::path hidden_checks_file(const LabEntry& lab);
/// Returns the content of that file.
std::string text_of(const HiddenByTask& hidden);

}  // namespace relief::check
