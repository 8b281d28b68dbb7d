// Files that a web page has not fetched yet. Only the browser's system (system_emscripten.cpp) implements this.
#pragma once

#include <set>
#include <string>

namespace relief {

/// The paths that the program tried to read and that do not exist, since a caller last emptied the set. The page
/// fetches those that the site has, and repeats its call.
std::set<std::string>& missing_files();

}  // namespace relief
