// The students' course: starters instead of solutions, exact values as pictures; no hidden checks, mistakes or
// variants.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "framework/staff/handout/delivery.h"

namespace relief::handout {

struct HandoutReport {
    std::string choice;  ///< "all", or the numbers of the labs, "1,2,10"
    bool is_new = true;  ///< the folder was not yet a handout
    int labs = 0, tasks = 0, files = 0, expected = 0;
    Delivery delivery = {};
};

/// Writes the students' course into `folder`, or updates it there: see deliver(). `labs` is "all" or an argument for
/// find_labs(); these labs are added to the labs in the folder. Without `labs`, the choice is the labs in the folder,
/// or all labs for a new folder.
///
/// Hands out everything except folders named `staff`, the tests and the slides; starters replace solutions. The
/// expected pictures of public checks go into the lab's folder `expected`. Needs a context. Throws Error if the folder
/// cannot be written, or if a lab's own solution fails one of its checks.
HandoutReport write_handout(const std::filesystem::path& folder, const std::optional<std::string>& labs = {});

}  // namespace relief::handout
