// A handout's Markdown as a part of a web page, with the same text as in the menu's help panel.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>

#include "framework/course/pages/markdown.h"
#include "framework/course/pages/template.h"

namespace relief::pages {

/// A picture for a page; its size is in pixels.
struct PagePicture {
    std::string file = {};
    int width = 0, height = 0;
    bool is_drawing = false;   ///< dark lines, which need a white ground
    std::string command = {};  ///< the command that draws it, or empty
    std::string moving = {};   ///< the text of a drawing that moves, in place of the file
    Value words = {};          ///< of {{> picture_words}}, to be laid over it, or empty
};

/// Resolve the targets of links and pictures for the page. Without a result only the words of the link stay.
struct PagePlaces {
    std::function<std::optional<std::string>(const std::string& target)> link;
    std::function<std::optional<PagePicture>(const std::string& target)> picture;
};

/// Returns the blocks for {{#name}}{{> block}}{{/name}}. Headings have ids. A picture that is a whole paragraph becomes
/// a figure, with its text as the caption. Wide tables and code scroll on their own. A block of the language `measured`
/// is folded. Throws Error for an invalid formula.
List markdown_blocks(std::span<const Block> blocks, const PagePlaces& places);

}  // namespace relief::pages
