// A lab's page in the course's web site: what it teaches, its tasks, and its methods with a wipe between any two.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "framework/lab/manifest.h"
#include "framework/pages/template.h"

namespace relief {

/// Files relative to the page. An empty name: there is none, and no link.
struct LabPage {
    /// A method's picture and error map, with what is said of it.
    struct Method {
        std::string name, picture, error_map;
        std::string error;  ///< its mean, "2.5 degrees", or empty
    };

    const LabEntry* lab = nullptr;
    const Manifest* manifest = nullptr;
    std::string picture;              ///< what the lab draws when it opens
    std::string card;                 ///< its picture on the course's first page
    std::string knob, probe;          ///< what is compared, and whose error is shown
    std::string command;              ///< that measures the last method's error, or empty
    std::vector<std::string> marks;   ///< of the error maps' scale
    glm::ivec2 size{0}, map_size{0};  ///< of the methods' pictures and error maps, pixels
    std::vector<Method> methods;      ///< two or more, or none
    std::string handout, slides, slides_to_print, bench;
    const LabPage *previous = nullptr, *next = nullptr;  ///< of the labs that have a page
};

/// "05_tangent_basis.html"
std::string lab_page_file(const LabEntry& lab);
std::string lab_page(const LabPage& page);

/// For {{> links}}: links in a row, without those that lead nowhere.
Value link_row(const std::vector<std::pair<std::string, std::string>>& links);

}  // namespace relief
