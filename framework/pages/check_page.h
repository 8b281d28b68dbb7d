// A lab's checks as one web page: what was found, what is allowed and why, and the pictures that were compared.
#pragma once

#include <string>
#include <vector>

#include "framework/check/check.h"

namespace relief {

/// What the student is to look at next. What does not draw has not been measured: then the check's own advice would
/// mislead.
std::string look_at(const CheckResult& result);

/// The page, with its pictures in it: it opens from disk and needs no network. Wants a context, to name its driver.
std::string check_page(const LabEntry& lab, const Manifest& manifest, const std::vector<TaskResult>& tasks);

}  // namespace relief
