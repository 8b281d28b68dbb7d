// A handout's words for a student who reads it beside the lab's page in a browser. Handouts are written for the course
// on a computer: they say `./relief run 11`, "save it" and "dropped on the window".
#pragma once

#include <string>

namespace relief::pages {

/// Returns a handout's Markdown with the page's own words for what one does there: its editor draws and checks at each
/// pause in typing, and files of a student's own have buttons. What only the course on a computer has says so. Other
/// commands stay.
std::string in_page_words(const std::string& markdown);

}  // namespace relief::pages
