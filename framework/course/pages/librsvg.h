// The function of the module that holds librsvg; framework/course/pages/svg.cpp opens it at first use.
#pragma once

#include <glm/glm.hpp>
#include <string>

#include "framework/core/image/image.h"

namespace relief {

/// Draws as draw_svg() does. Precondition: `size` is a valid image size (see max_image_side).
using DrawSvg = Image(const std::string& svg, glm::ivec2 size);

}  // namespace relief

extern "C" {
relief::DrawSvg relief_draw_svg;
}
