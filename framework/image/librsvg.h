// The function of the module that holds librsvg; framework/image/svg.cpp opens it at first use.
#pragma once

#include <glm/glm.hpp>
#include <string>

#include "framework/image/image.h"

namespace relief {

/// As draw_svg() says; the size is one of an image.
using DrawSvg = Image(const std::string& svg, glm::ivec2 size);

}  // namespace relief

extern "C" {
relief::DrawSvg relief_draw_svg;
}
