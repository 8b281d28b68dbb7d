// Values for the templates of pictures in pages: a figure, and the scale of an error map.
#pragma once

#include <string>
#include <vector>

#include "framework/core/image/image.h"
#include "framework/course/pages/template.h"

namespace relief::pages {

/// Returns the fields of {{> figure}}, for a picture at `src` in the page. `scale` goes below it.
Fields figure(const Image& image, const std::string& src, const char* kind, const std::string& caption,
              const std::string& alt, Value scale = {});

/// Returns the value of {{> scale}} below an error map: the colours of visualize_error() with evenly spaced marks. The
/// last mark reads "and more".
Value error_scale(std::vector<std::string> marks);

}  // namespace relief::pages
