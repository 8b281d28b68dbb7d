// What templates of pages with pictures are given: a figure, the scale of an error map.
#pragma once

#include <string>
#include <vector>

#include "framework/image/image.h"
#include "framework/pages/template.h"

namespace relief {

/// For {{> figure}}: a picture that the page has at `src`; `scale` stands below it.
Fields figure(const Image& image, const std::string& src, const char* kind, const std::string& caption,
              const std::string& alt, Value scale = {});

/// For {{> scale}} below an error map: the colours of visualize_error() with marks at even distances, the last one "and
/// more".
Value error_scale(std::vector<std::string> marks);

}  // namespace relief
