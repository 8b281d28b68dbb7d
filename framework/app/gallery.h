// relief gallery: the course's web site.
#pragma once

#include <filesystem>
#include <string>

#include "framework/app/command.h"

namespace relief {

/// Into `folder`, or below the course's build folder when it is empty; of `labs` (see find_labs()) or of all. 1 when a
/// lab is broken: the others are there.
int make_gallery(std::filesystem::path folder, const std::string& labs, ContextChoice context);

}  // namespace relief
