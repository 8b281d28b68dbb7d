// Images of numbers that a lab computes for itself, on the GPU or by rays.
#pragma once

#include <array>
#include <functional>
#include <glm/glm.hpp>
#include <optional>

#include "framework/core/image/image.h"
#include "framework/core/lab/lab.h"

namespace relief {

/// Calls `draw` with a framebuffer of its own and returns the result, four floats per pixel: +infinity where nothing is
/// drawn. The viewport is the whole framebuffer. Restores framebuffer and
/// viewport.
Image draw_numbers(glm::ivec2 size, const std::function<void()>& draw);

/// Calls `draw` with a framebuffer of one pixel: the one at column and row `pixel` of a picture of `size`, which is the
/// viewport. Returns the values of its fragment shader's outputs 0 to 3; they are 0 where nothing is drawn. Restores
/// framebuffer and viewport.
std::array<glm::vec4, 4> draw_pixel(glm::ivec2 size, glm::ivec2 pixel, const std::function<void()>& draw);

/// Returns an image of four floats per pixel; row 0 is the top. `value` gets column and row, and must be thread-safe.
Image image_of_values(glm::ivec2 size, const std::function<glm::dvec4(int x, int y)>& value);

/// Returns the truth of a frame, computed from the ray of each pixel; +infinity where `value` returns nothing. `value`
/// must be thread-safe.
Image truth_of_rays(const Frame& frame, const std::function<std::optional<glm::dvec4>(const Ray&)>& value);

}  // namespace relief
