// relief gallery: the course's web site.
#pragma once

#include <filesystem>
#include <string>

#include "framework/course/app/command.h"

namespace relief::app {

struct GalleryOptions {
    std::filesystem::path folder = {};  ///< empty: below the course's build folder
    std::string labs = {};              ///< see find_labs(); empty: all
    /// Links each lab's page to live_page_file(), and leaves out slides and measurements.
    bool is_live = false;
};

/// Writes the site, for which a context must be current. Returns 1 if a lab is broken; the others are still written.
int make_gallery(GalleryOptions options);

}  // namespace relief::app
