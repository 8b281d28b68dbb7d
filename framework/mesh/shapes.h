// Meshes of surfaces with a formula: their normals and tangents (dP/du) are exact, not averaged.
//
// Seen from outside, u grows to the right and v up, so tangent.w is 1 everywhere. uv run from 0 to `repeat` (on each
// face of a box and a cube sphere). The vertices on both sides of a seam or an edge agree to the last bit.
// Whatever the numbers, positions are finite and frames are unit and perpendicular: a size or `repeat` is taken without
// its sign, as 0 when it is not finite, and as 1e18 at most; a count as the least that makes the shape, or as 4096 at
// most.
#pragma once

#include "framework/mesh/mesh.h"

namespace relief {

/// A rectangle in the plane z = 0 that faces +z, centred on the origin; u runs along x, v along y.
struct QuadShape {
    float width = 1, height = 1;
    int columns = 1, rows = 1;
    glm::vec2 repeat = {1, 1};  ///< how often the texture repeats along u and v
};
Mesh make_quad(const QuadShape& shape);

/// A ground: a rectangle in the plane y = 0 that faces +y, centred on the origin; u runs along x, v along -z.
struct GridShape {
    float width = 1, depth = 1;
    int columns = 16, rows = 16;
    glm::vec2 repeat = {1, 1};
};
Mesh make_grid(const GridShape& shape);

/// A box around the origin with hard edges: six faces of vertices of their own, so 24 where `cells` is 1. v runs up on
/// the four sides, along -z on the top and +z on the bottom. A box without extent keeps the frames of its faces.
struct BoxShape {
    glm::vec3 size = {1, 1, 1};
    glm::ivec3 cells = {1, 1, 1};  ///< along x, y and z
    glm::vec2 repeat = {1, 1};
};
Mesh make_box(const BoxShape& shape);

/// A column that stands on y = 0, without caps; u runs around (to the right, seen from outside), v up. Without height
/// and taper its normals point away from the axis.
struct ColumnShape {
    float bottom_radius = 1, top_radius = 1, height = 1;
    int sides = 48, rows = 8;
    glm::vec2 repeat = {1, 1};
};
Mesh make_column(const ColumnShape& shape);

/// A disc in the plane y = 0 that faces +y, in polar coordinates: u runs around, as on a column below it, v from the
/// rim to the centre. At the centre each vertex keeps the tangent of its own spoke; without radius the disc is a point
/// whose normals point away from the axis, as a column's do.
struct DiscShape {
    float radius = 1;
    int sides = 48, rows = 8;
    glm::vec2 repeat = {1, 1};
};
Mesh make_disc(const DiscShape& shape);

/// A sphere around the origin; u runs around from -z (to the right, seen from outside), v from the lower pole
/// to the upper one. At a pole each of its vertices keeps the tangent of its own meridian; their positions agree within
/// 1e-16 of the radius.
struct SphereShape {
    float radius = 1;
    int sides = 48, rows = 24;
    glm::vec2 repeat = {1, 1};
};
Mesh make_sphere(const SphereShape& shape);

/// A sphere without poles: the faces of a box, with `cells` along each edge, blown up. A face's lines of constant u,
/// and of constant v, lie at equal angles (Ronchi, Iacono and Paolucci 1996), so cells differ in area by no more than
/// sqrt(2). dP/du is discontinuous where two faces meet; each keeps its own vertices there.
struct CubeSphereShape {
    float radius = 1;
    int cells = 16;
    glm::vec2 repeat = {1, 1};
};
Mesh make_cube_sphere(const CubeSphereShape& shape);

/// A face of the cube [-1, 1]³: its outward normal, and its directions of u and v. They are +x, -x, +y, -y, +z, -z.
struct CubeFace {
    glm::dvec3 normal, right, up;
};
const CubeFace& cube_face(int face);

/// Of unit length: the place (s, t) of a face, each from -1 to 1; beyond that the face's lines go on. Places that two
/// faces share agree to the last bit.
glm::dvec3 cube_sphere_direction(int face, double s, double t);

/// A ring around the y axis: a tube (at most as thick as the ring, where its hole closes) around a circle. u runs
/// around the axis from -z (to the right, seen from outside), v around the tube from the hole by way of the bottom, so
/// v = repeat / 2 is the outer equator.
struct TorusShape {
    float ring_radius = 1, tube_radius = 0.25f;
    int sides = 64, rows = 24;
    glm::vec2 repeat = {1, 1};
};
Mesh make_torus(const TorusShape& shape);

}  // namespace relief
