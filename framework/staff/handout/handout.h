// The students' course: starters instead of solutions, exact values as pictures; no hidden checks, mistakes or
// variants.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "framework/staff/handout/delivery.h"

namespace relief {

struct HandoutReport {
    std::string choice;  ///< "all", or the numbers of the labs, "1,2,10"
    bool is_new = true;  ///< the folder was not yet a handout
    int labs = 0, tasks = 0, files = 0, expected = 0;
    Delivery delivery = {};
};

/// Writes the students' course into `folder`, or updates it there: see deliver(). `labs`: as find_labs() takes them, or
/// "all"; they are added to the labs that the folder has. Without `labs`: the labs that the folder has, or all for a
/// new folder.
///
/// Everything is handed out except folders named `staff`, the tests and the slides; starters replace solutions. The
/// pictures that public checks compare with are put into the lab's folder `expected`. Needs a context. Throws Error if
/// the folder cannot be written, or if a lab's own solution fails one of its checks.
HandoutReport write_handout(const std::filesystem::path& folder, const std::optional<std::string>& labs = {});

}  // namespace relief
