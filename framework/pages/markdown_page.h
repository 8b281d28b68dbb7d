// A handout's Markdown as a part of a web page: the same text as the menu's help panel shows.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>

#include "framework/base/markdown.h"
#include "framework/pages/template.h"

namespace relief {

/// A picture that a page may name, in pixels.
struct PagePicture {
    std::string file = {};
    int width = 0, height = 0;
    bool is_drawing = false;   ///< dark lines, for a white ground
    std::string command = {};  ///< what draws it, or empty
};

/// Where in the page's world the targets of links and pictures are; for whatever is not there the words stay.
struct PagePlaces {
    std::function<std::optional<std::string>(const std::string& target)> link;
    std::function<std::optional<PagePicture>(const std::string& target)> picture;
};

/// For {{#name}}{{> block}}{{/name}}: headings have ids; a picture that is a whole paragraph is a figure with its text
/// as caption; wide tables and code scroll in themselves; a block of the language `measured` is folded. Throws Error
/// for a formula that cannot be read.
List markdown_blocks(std::span<const Block> blocks, const PagePlaces& places);

}  // namespace relief
