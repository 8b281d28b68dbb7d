// The shading of one point, in double precision. The twin of shaders/common/light.glsl.
#pragma once

#include <glm/glm.hpp>

namespace relief {

/// Returns the reflected light of one light of unit strength, including the cosine: Lambert plus Blinn-Phong (Blinn
/// 1977), normalised by (shininess + 8) / 8 (Akenine-Möller et al. 2008). Directions have unit length and point away
/// from the surface. If light and eye are opposite, there is no highlight.
glm::dvec3 blinn_phong(const glm::dvec3& albedo, double specular, double shininess, const glm::dvec3& normal,
                       const glm::dvec3& to_light, const glm::dvec3& to_eye);

}  // namespace relief
