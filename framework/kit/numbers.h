// Images of numbers that a lab needs for itself: measured on the GPU, or by rays.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <optional>

#include "framework/image/image.h"
#include "framework/lab/lab.h"

namespace relief {

/// What `draw` draws into a target of its own, four floats a pixel; +infinity where nothing is drawn, not_written where
/// a task is missing. The viewport is the whole target. Afterwards framebuffer and viewport are as they were.
Image draw_numbers(glm::ivec2 size, const std::function<void()>& draw);

/// An image of four floats a pixel; row 0 is the top. Several threads call `value`, which gets column and row.
Image image_of_values(glm::ivec2 size, const std::function<glm::dvec4(int x, int y)>& value);

/// The truth of a frame from what the ray of each pixel sees; +infinity where that is nothing. Several threads call
/// `value`.
Image truth_of_rays(const Frame& frame, const std::function<std::optional<glm::dvec4>(const Ray&)>& value);

}  // namespace relief
