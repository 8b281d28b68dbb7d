// The students' course: starters instead of solutions, no hidden checks, no mistakes or variants, and the exact values
// as pictures.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "framework/staff/handout/delivery.h"

namespace relief {

struct HandoutReport {
    std::string choice;  ///< "all", or the numbers of the labs, "1,2,10"
    bool is_new = true;  ///< the folder was not a handout before
    int labs = 0, tasks = 0, files = 0, expected = 0;
    Delivery delivery = {};
};

/// Writes the course for students into `folder`, or brings it up to date there: see deliver(). `labs` is what
/// find_labs() takes, or "all"; they are added to those that the folder has. Nothing means those that it has, and all
/// for a new one.
///
/// A folder named `staff` never leaves, nor do the tests and the slides; everything else does, with starters in place
/// of solutions. What a public check compares with lies in the lab's folder `expected`. Wants a context. Throws Error
/// when that is not possible, and when a lab that is to be handed out has a check that its own solution does not pass:
/// nobody could.
HandoutReport write_handout(const std::filesystem::path& folder, const std::optional<std::string>& labs = {});

}  // namespace relief
