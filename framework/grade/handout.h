// The student's course: starters in place of solutions, no hidden checks, no mistakes, and the truth as pictures.
#pragma once

#include <filesystem>
#include <string>

namespace relief {

struct HandoutReport {
    int labs = 0, tasks = 0, files = 0, expected = 0;
};

/// Writes the whole course for students into `folder`, which must be empty or not there. Left out are the tests, the
/// exact values in framework/reference, the benchmark, and what the labs' manifests name in `keep_back`; of
/// shaders/common only what a lab includes goes along. What a public check compares with lies in the lab's folder
/// `expected`. Wants a context. Throws Error when that is not possible, also when a lab includes what another keeps
/// back.
HandoutReport write_handout(const std::filesystem::path& folder);

/// A manifest's text without its hidden checks and its mistakes, and without the comments right above them.
std::string public_manifest(const std::string& text, const std::filesystem::path& file);

}  // namespace relief
