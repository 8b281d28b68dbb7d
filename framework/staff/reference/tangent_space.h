// Frames at a surface and directions in them, in double precision. The twin of shaders/staff/tangent_space.glsl.
#pragma once

#include <glm/glm.hpp>

namespace relief {

/// Columns tangent, bitangent, normal: unit and at right angles by Gram-Schmidt, which keeps the normal's direction;
/// bitangent = tangent.w cross(normal, tangent). Neither need be normalised; a tangent along the normal, or a zero one
/// of either, gives a frame that is not a number.
glm::dmat3 tangent_frame(const glm::dvec3& normal, const glm::dvec4& tangent);

/// From tangent space to the space of `normal` and `tangent`, normalised.
glm::dvec3 from_tangent_space(const glm::dvec3& direction, const glm::dvec3& normal, const glm::dvec4& tangent);

/// The other way round; a frame at right angles is undone by its transpose.
glm::dvec3 to_tangent_space(const glm::dvec3& direction, const glm::dvec3& normal, const glm::dvec4& tangent);

/// Columns tangent, bitangent, normal as they are interpolated, neither unit nor perpendicular: the frame of MikkTSpace
/// and of all that bake for it (Mikkelsen 2008). The frame is a convention: whoever makes the map decides.
glm::dmat3 interpolated_frame(const glm::dvec3& normal, const glm::dvec4& tangent);
glm::dvec3 from_interpolated_frame(const glm::dvec3& direction, const glm::dvec3& normal, const glm::dvec4& tangent);
/// The other way round. Where normal and tangent are parallel, or one is 0, the result is not a number.
glm::dvec3 to_interpolated_frame(const glm::dvec3& direction, const glm::dvec3& normal, const glm::dvec4& tangent);

/// A frame from how position and uv change to two neighbours (dFdx and dFdy in a shader), without a tangent at the
/// vertices (Schuler 2013). Its first two columns are the gradients of u and v on the surface, scaled together so that
/// the longer is unit: not at right angles where the uv are sheared. Zero columns where the uv do not change.
glm::dmat3 cotangent_frame(const glm::dvec3& normal, const glm::dvec3& position_dx, const glm::dvec3& position_dy,
                           const glm::dvec2& uv_dx, const glm::dvec2& uv_dy);

}  // namespace relief
