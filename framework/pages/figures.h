// Shared parts of pages with pictures: the wipe between two, the scale of an error map, numbers with their unit.
#pragma once

#include <string>
#include <vector>

namespace relief {

/// The look of both; see closed_page().
std::string figures_style();

/// Below an error map: the colours of visualize_error() with marks at even distances, the last one "and more".
std::string error_scale(const std::vector<std::string>& marks);

/// A script's function, wipe(under, over, words, name, value, told): lays one image upon the other and gives the slider
/// between them with its `words`, to be put where it belongs, and slide(), for when anything has changed. `name` is the
/// slider's for a screen reader, `told(value)` what it says there. At 0 only `under` is seen, at 100 only `over`.
extern const char* const wipe_function;

}  // namespace relief
