// Commonly copied code, rewritten here from its published description: peers of the course's methods.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "framework/core/base/mesh.h"
#include "framework/core/image/image.h"
#include "framework/staff/reference/normal_codec.h"

namespace relief::measure {

/// Computes tangents at the vertices (Lengyel 2001): sums over the triangles, then Gram-Schmidt, in single precision.
/// `sums` is reusable working memory.
void usual_tangents(const Mesh& mesh, std::vector<glm::vec3>& sums, std::vector<glm::vec4>& tangents);

/// Computes normals from heights: Sobel's weights in a loop over the texels; a function wraps the coordinates of each
/// neighbour. `texels` is the size of height 1 in texels. `normals` has the size of the heights, and 3 channels: 0.5 n
/// + 0.5.
void usual_normals(const Image& heights, double texels, Image& normals);

/// Returns the normals of slopes in OpenImageIO's format: dh/du and dh/dv per texel, v downwards.
Image normals_of_slopes(const Image& slopes, double texels);

/// Encodes a normal in three bytes: 255 (0.5 x + 0.5), truncated; and the inverse.
NormalCode usual_code(const glm::dvec3& normal);
glm::dvec3 usual_normal(const NormalCode& code);

}  // namespace relief::measure
