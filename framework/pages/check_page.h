// A lab's checks as one web page: what was found, what is allowed and why, and the pictures that were compared.
#pragma once

#include <string>
#include <vector>

#include "framework/check/check.h"

namespace relief {

/// The hint for the student. If nothing was drawn, nothing was measured, and the check's own hint would
/// mislead.
std::string look_at(const CheckResult& result);

/// The page, with its pictures in it: it opens from disk and needs no network. Needs a context, to name its driver.
std::string check_page(const LabEntry& lab, const Manifest& manifest, const std::vector<TaskResult>& tasks);

}  // namespace relief
