// The shapes of lab 05 as parametric surfaces P(u, v), and as coarse meshes of them.
#pragma once

#include <cstdint>
#include <vector>

#include "framework/mesh/mesh.h"

namespace relief::basis {

enum class Shape { quad, box, cylinder, sphere, torus, mirrored, urn };

/// A place of a surface: unit normal, and unit dP/du with the handedness in w.
struct Place {
    glm::dvec3 position, normal;
    glm::dvec4 tangent;
};

/// u and v in [0, 1] over the whole surface (a box has its six faces side by side along u). For `mirrored`, a sphere
/// whose texture is on its left half what it is on its right one, u is that of the sphere; for `quad`, `shear` is how
/// much v grows along x.
Place place_on(Shape shape, glm::dvec2 uv, double shear);

/// A mesh with exact normals and tangents. `jitter` moves inner vertices along the surface by up to that share of half
/// a cell, and then each cell has its diagonal by chance. `places` are the u and v of place_on() at its vertices.
struct CoarseMesh {
    Mesh mesh;
    std::vector<glm::dvec2> places;
};
CoarseMesh coarse_mesh(Shape shape, int columns, int rows, double jitter, double shear);

}  // namespace relief::basis
