// Tangent frames, and directions in them, in double precision.
#pragma once

#include <glm/glm.hpp>

namespace relief {

/// Returns a frame whose columns are tangent, bitangent and normal, made orthonormal by Gram-Schmidt; the normal keeps
/// its direction. bitangent = tangent.w cross(normal, tangent). The arguments can have any length. NaN if one is zero,
/// or if they are parallel.
glm::dmat3 tangent_frame(const glm::dvec3& normal, const glm::dvec4& tangent);

/// Transforms a direction from tangent space to the space of `normal` and `tangent`. The result is normalised.
glm::dvec3 from_tangent_space(const glm::dvec3& direction, const glm::dvec3& normal, const glm::dvec4& tangent);

/// The inverse of from_tangent_space(): the frame is orthonormal, so its transpose is its inverse.
glm::dvec3 to_tangent_space(const glm::dvec3& direction, const glm::dvec3& normal, const glm::dvec4& tangent);

/// Returns a frame whose columns are tangent, bitangent and normal as interpolated, neither normalised nor
/// perpendicular. This is the frame of MikkTSpace (Mikkelsen 2008) with the bitangent of each pixel. The program that
/// bakes a map decides which frame it needs.
glm::dmat3 interpolated_frame(const glm::dvec3& normal, const glm::dvec4& tangent);
/// Transforms a direction into the interpolated frame. The result is normalised. NaN if normal and tangent are
/// parallel, or if one is zero.
glm::dvec3 to_interpolated_frame(const glm::dvec3& direction, const glm::dvec3& normal, const glm::dvec4& tangent);

}  // namespace relief
