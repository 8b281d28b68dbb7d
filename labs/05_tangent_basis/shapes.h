// The shapes of lab 05 as parametric surfaces P(u, v), and as coarse meshes of them.
#pragma once

#include <cstdint>
#include <vector>

#include "framework/core/base/mesh.h"
#include "framework/library/kit/choices.h"

namespace relief::basis {

enum class Shape { quad, box, cylinder, sphere, torus, mirrored, urn, own };
/// Their names, and the definitions of the surfaces of which the shader knows dP/du; that of the torus is for frames.
inline constexpr auto shapes = choices<Shape>({{Shape::quad, "quad", "QUAD"},
                                               {Shape::box, "box", "BOX"},
                                               {Shape::cylinder, "cylinder"},
                                               {Shape::sphere, "sphere"},
                                               {Shape::torus, "torus", "TORUS"},
                                               {Shape::mirrored, "mirrored", "MIRRORED"},
                                               {Shape::urn, "urn"}});
constexpr double box_half = 0.62;  ///< half the side of the box, metres

/// A place on a surface. The normal has unit length. `tangent` is dP/du, normalized, with the handedness in w.
struct Place {
    glm::dvec3 position, normal;
    glm::dvec4 tangent;
};

/// Returns the place at u and v, each in [0, 1] over the whole surface. A box has its six faces side by side along u.
/// `mirrored` is a sphere whose left half shows the mirrored texture of the right one; u is that of the sphere. The
/// texture of a quad is sheared: its v is v + shear * u.
Place place_on(Shape shape, glm::dvec2 uv, double shear);

/// A mesh with exact normals and tangents. `places` are the u and v of place_on() at its vertices.
struct CoarseMesh {
    Mesh mesh;
    std::vector<glm::dvec2> places;
};
/// Returns a mesh of columns x rows cells. `jitter` in [0, 1] moves inner vertices along the surface by up to
/// 0.33 * jitter cells. If it is above 0, the diagonals of cells are random, too. The urn comes from a file and has no
/// jitter. Precondition: the shape is not `own`, which has no formula.
CoarseMesh coarse_mesh(Shape shape, int columns, int rows, double jitter, double shear);

}  // namespace relief::basis
