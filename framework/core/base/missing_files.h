// Files that a web page has not fetched yet. Only the browser's system (system_emscripten.cpp) implements this.
#pragma once

#include <set>
#include <string>

namespace relief {

/// The paths of empty files that the program tried to read, since a caller last emptied the set. The page fetches them,
/// and repeats its call.
std::set<std::string>& missing_files();

}  // namespace relief
