// What normal maps store, back to directions, in double precision. The twin of shaders/staff/normal_map.glsl.
#pragma once

#include <glm/glm.hpp>

namespace relief {

/// Of c = 255 (0.5 x + 0.5) as a sampler gives it, in [0, 1]. Not unit.
glm::dvec3 decode_normal(const glm::dvec3& stored);

/// Of c = 127 x + 128, in which 128 is 0 exactly. Not unit.
glm::dvec3 decode_normal_128(const glm::dvec3& stored);

/// Of x and y alone, in [-1, 1]: unit with z >= 0, or z = 0 where x and y are too long.
glm::dvec3 decode_normal_xy(const glm::dvec2& xy);

/// Of an octahedral map, in [-1, 1] (Meyer et al. 2010; Cigolle et al. 2014). Unit.
glm::dvec3 decode_octahedral(const glm::dvec2& stored);

}  // namespace relief
