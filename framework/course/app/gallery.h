// relief gallery: the course's web site.
#pragma once

#include <filesystem>
#include <string>

#include "framework/course/app/command.h"

namespace relief::app {

/// Writes the site of `labs` (see find_labs(); empty: all) into `folder`, or below the course's build folder if
/// `folder` is empty. Returns 1 if a lab is broken; the others are still written.
int make_gallery(std::filesystem::path folder, const std::string& labs, ContextChoice context);

}  // namespace relief::app
