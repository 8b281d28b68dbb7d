// The student's course: starters in place of solutions, no hidden checks, no mistakes or variants, and the truth as
// pictures.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "framework/grade/delivery.h"

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
/// Left out are the tests, the exact values in framework/reference, the benchmark, and what the manifests of the whole
/// course name in `keep_back`, whichever labs are handed out; of shaders/common only what the handed out labs include
/// goes along. What a public check compares with lies in the lab's folder `expected`. Wants a context. Throws Error
/// when that is not possible, also when any lab of the course includes what another keeps back, or a shader of another,
/// and when a lab that is to be handed out has a check that its own solution does not pass: nobody could.
HandoutReport write_handout(const std::filesystem::path& folder, const std::optional<std::string>& labs = {});

/// A manifest's text without its hidden checks, its mistakes and its correct variants, and without the comments right
/// above them.
std::string public_manifest(const std::string& text, const std::filesystem::path& file);

}  // namespace relief
