// Runs a lab's checks in copies of this process: a fault in a student's code ends a copy, and the other checks keep
// their results.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "framework/course/check/verdict.h"
#include "framework/course/check/watchdog.h"
#include "framework/course/manifest/manifest.h"

namespace relief {
struct LabEntry;
}

namespace relief::check {

struct CheckedLab {
    std::vector<TaskVerdict> tasks;
    std::string driver;  ///< see ContextInfo::driver()
};

/// The verdicts that have their pictures. Those of all checks of a lab are tens of megabytes.
enum class KeptPictures { of_failed, of_all };

/// Runs all checks of a lab, task by task, and names known mistakes. Precondition: this process has no context and no
/// other thread. Each copy opens a context, and draws until its end or until a check ends it: that check is `crashed`,
/// `out_of_time` or `out_of_memory`, and another copy runs the rest. After a check that is out of time, the other
/// checks of its task are not tried; at the end of the lab's time, none. Prints what the task prints, on standard
/// error. Throws Error if a task has no check.
///
/// Where the system cannot copy a process, the checks run in this one, and a fault ends it.
///
/// `begins` is called in the copy before each check, for tests.
CheckedLab check_lab_apart(const LabEntry& lab, const Manifest& manifest, const PatienceLimits& limits,
                           KeptPictures pictures = KeptPictures::of_failed,
                           const std::function<void(const CheckInfo& check)>& begins = {});

}  // namespace relief::check
