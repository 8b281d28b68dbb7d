// SVG pictures, such as the handouts' diagrams: drawn by librsvg, which is opened at first use.
#pragma once

#include <glm/glm.hpp>
#include <string>

#include "framework/image/image.h"

namespace relief {

/// Width and height of an SVG picture in units of its own, both above 0, from viewBox="0 0 WIDTH HEIGHT". Throws Error
/// without a place if it has none.
glm::ivec2 svg_size(const std::string& svg);

/// The picture on white paper, as large as fits into `size` pixels, in the middle: three channels, 8 bits, sRGB. Throws
/// Error without a place if it is not SVG, if the size is not one of an image (see max_image_side), or if librsvg is
/// missing.
Image draw_svg(const std::string& svg, glm::ivec2 size);

}  // namespace relief
