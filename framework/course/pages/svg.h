// SVG pictures, such as the diagrams of handouts. They are drawn by librsvg, which is opened at first use.
#pragma once

#include <glm/glm.hpp>
#include <string>

#include "framework/core/image/image.h"

namespace relief {

/// Returns width and height of an SVG picture in its own units, both above 0, from viewBox="0 0 WIDTH HEIGHT". Throws
/// Error without a place when there is no such viewBox.
glm::ivec2 svg_size(const std::string& svg);

/// Returns whether the picture says data-moves="NAME": drawings.js moves it in a page that has its text.
bool is_moving_drawing(const std::string& svg);

/// Draws the picture on white, centred, as large as fits into `size` pixels. The result has three channels, 8 bits,
/// sRGB. Throws Error without a place if the text is not SVG, if `size` is not a valid image size (see max_image_side),
/// or if librsvg is missing.
Image draw_svg(const std::string& svg, glm::ivec2 size);

}  // namespace relief
