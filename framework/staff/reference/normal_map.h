// Directions from the stored values of normal maps, in double precision. The twin of shaders/staff/normal_map.glsl.
#pragma once

#include <glm/glm.hpp>

namespace relief {

/// Decodes c = 255 (0.5 x + 0.5). `stored` is c / 255, as a sampler returns it. The result is not normalised.
glm::dvec3 decode_normal(const glm::dvec3& stored);

/// Decodes c = 127 x + 128, where 128 is exactly 0. `stored` is c / 255. The result is not normalised.
glm::dvec3 decode_normal_128(const glm::dvec3& stored);

/// Adds z >= 0 to x and y in [-1, 1] so that the length is 1. If (x, y) is longer than 1, z is 0.
glm::dvec3 decode_normal_xy(const glm::dvec2& xy);

/// Decodes an octahedral map (Meyer et al. 2010; Cigolle et al. 2014), stored in [-1, 1]. The result has unit length.
glm::dvec3 decode_octahedral(const glm::dvec2& stored);

}  // namespace relief
