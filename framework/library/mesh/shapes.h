// Meshes of surfaces that have a formula. Normals and tangents (dP/du) are exact, not averaged.
//
// Seen from outside, u grows to the right and v up, so tangent.w is 1 everywhere. uv run from 0 to `repeat` (on each
// face of a box and a cube sphere). Vertices on both sides of a seam or an edge agree to the last bit.
// For any parameters, positions are finite, and frames are perpendicular unit vectors. A size or `repeat` that is not
// finite counts as 0; of any other, the magnitude counts, clamped to 1e18. Counts are clamped from the minimum that
// makes the shape to 4096.
#pragma once

#include "framework/core/base/mesh.h"

namespace relief {

/// A rectangle in the plane z = 0 that faces +z, centred on the origin; u runs along x, v along y.
struct QuadShape {
    float width = 1, height = 1;
    int columns = 1, rows = 1;
    glm::vec2 repeat = {1, 1};  ///< number of texture tiles along u and v
};
Mesh make_quad(const QuadShape& shape);

/// A ground: a rectangle in the plane y = 0 that faces +y, centred on the origin; u runs along x, v along -z.
struct GridShape {
    float width = 1, depth = 1;
    int columns = 16, rows = 16;
    glm::vec2 repeat = {1, 1};
};
Mesh make_grid(const GridShape& shape);

/// A box around the origin with hard edges. The six faces share no vertices, so there are 24 where `cells` is 1. v runs
/// up on the four sides, along -z on the top and +z on the bottom. A box without extent keeps the frames of its faces.
struct BoxShape {
    glm::vec3 size = {1, 1, 1};
    glm::ivec3 cells = {1, 1, 1};  ///< along x, y and z
    glm::vec2 repeat = {1, 1};
};
Mesh make_box(const BoxShape& shape);

/// A column on y = 0, without caps. u runs around (to the right, seen from outside), v up. If its height is 0 and its
/// radii are equal, its normals point away from the axis.
struct ColumnShape {
    float bottom_radius = 1, top_radius = 1, height = 1;
    int sides = 48, rows = 8;
    glm::vec2 repeat = {1, 1};
};
Mesh make_column(const ColumnShape& shape);

/// A sphere around the origin. u runs around from -z (to the right, seen from outside), v from the lower pole to the
/// upper one. At a pole, each vertex keeps the tangent of its own meridian. Positions at a pole agree within 1e-16 of
/// the radius.
struct SphereShape {
    float radius = 1;
    int sides = 48, rows = 24;
    glm::vec2 repeat = {1, 1};
};
Mesh make_sphere(const SphereShape& shape);

/// A sphere without poles: the faces of a cube, with `cells` along each edge, projected to the sphere. A face's lines
/// of constant u, and of constant v, lie at equal angles (Ronchi, Iacono and Paolucci 1996). So the areas of cells
/// differ by at most a factor of sqrt(2). dP/du is discontinuous where two faces meet; each face has its own vertices
/// there.
struct CubeSphereShape {
    float radius = 1;
    int cells = 16;
    glm::vec2 repeat = {1, 1};
};
Mesh make_cube_sphere(const CubeSphereShape& shape);

/// A face of the cube [-1, 1]³: its outward normal, and its directions of u and v. Faces 0 to 5 are +x, -x, +y, -y, +z,
/// -z.
struct CubeFace {
    glm::dvec3 normal, right, up;
};
const CubeFace& cube_face(int face);

/// Returns the unit vector to the point (s, t) of a face, each from -1 to 1; beyond that range, the face's lines
/// continue. Points that two faces share agree to the last bit.
glm::dvec3 cube_sphere_direction(int face, double s, double t);

/// A torus around the y axis. The tube's radius is clamped to the ring's, where the hole closes. u runs around the axis
/// from -z (to the right, seen from outside). v runs around the tube from the hole by way of the bottom, so v = repeat
/// / 2 is the outer equator.
struct TorusShape {
    float ring_radius = 1, tube_radius = 0.25f;
    int sides = 64, rows = 24;
    glm::vec2 repeat = {1, 1};
};
Mesh make_torus(const TorusShape& shape);

}  // namespace relief
