// Images of numbers that a lab needs for itself: measured on the GPU, or by rays.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <optional>

#include "framework/image/image.h"
#include "framework/lab/lab.h"

namespace relief {

/// What `draw` draws into a target of its own, four floats a pixel; +infinity where nothing is drawn. The viewport is
/// the whole target. Afterwards framebuffer and viewport are as they were.
Image draw_numbers(glm::ivec2 size, const std::function<void()>& draw);

/// The truth of a frame from what the ray of each pixel sees; +infinity where that is nothing. Several threads call
/// `value`.
Image truth_of_rays(const Frame& frame, const std::function<std::optional<glm::dvec4>(const Ray&)>& value);

}  // namespace relief
