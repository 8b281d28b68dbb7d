// A lab's handout as a page of the course's web site: contents, figures with the command that draws them, neighbours.
#pragma once

#include <functional>
#include <span>
#include <string>

#include "framework/lab/manifest.h"

namespace relief {

/// "05_tangent_basis-handout.html"
std::string handout_file(const LabEntry& lab);

/// `labs`: all that have a page, in order. `put` writes a file of that name beside the page. Throws Error for a picture
/// that is not there and for a formula that cannot be read.
std::string handout_page(const LabEntry& lab, const Manifest& manifest, std::span<const LabEntry* const> labs,
                         const std::function<void(const std::string& name, const std::string& bytes)>& put);

}  // namespace relief
