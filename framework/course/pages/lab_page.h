// A lab's page in the course's web site: its topic, its tasks, and its methods with a wipe between any two.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "framework/course/manifest/manifest.h"
#include "framework/course/pages/template.h"

namespace relief::pages {

/// The content of a lab's page. Files are relative to the page. An empty name: no such file, and no link.
struct LabPage {
    /// A method's picture and error map, with its name and mean error.
    struct Method {
        std::string name, picture, error_map;
        std::string error;  ///< mean error, "2.5 degrees", or empty
    };

    const LabEntry* lab = nullptr;
    const Manifest* manifest = nullptr;
    std::string picture;              ///< the lab's view when it opens
    std::string card;                 ///< the lab's picture on the course's first page
    std::string knob, probe;          ///< the compared knob, and the probe of the errors
    std::string command;              ///< measures the last method's error; or empty
    std::vector<std::string> marks;   ///< marks of the error maps' scale
    glm::ivec2 size{0}, map_size{0};  ///< of the methods' pictures and error maps, in pixels
    std::vector<Method> methods;      ///< empty, or at least two
    std::string live, handout, slides, slides_to_print, bench;
    const LabPage *previous = nullptr, *next = nullptr;  ///< among the labs with a page
};

/// Returns the page's file name, such as "05_tangent_basis.html".
std::string lab_page_file(const LabEntry& lab);
std::string lab_page(const LabPage& page);
/// Returns the name of the page on which the lab runs in the browser, such as "05_tangent_basis-live.html".
std::string live_page_file(const LabEntry& lab);

/// Returns the value of {{> links}}: links in a row, without the empty ones.
Value link_row(const std::vector<std::pair<std::string, std::string>>& links);

}  // namespace relief::pages
