// A mesh cut into patches for tessellation, so that a relief on it has no crack: what two patches share, both know in
// the same bits.
#pragma once

#include <vector>

#include "framework/mesh/mesh.h"

namespace relief {

/// Where two patches meet, their uv and normals may differ (at a seam, a hard edge), and each would displace the shared
/// place elsewhere. So places and edges have an owner, the first corner or patch that has them, whose uv all read their
/// height at (McDonald and Kilgard 2010), and one direction. Where nothing differs it is what the vertex has.
struct PatchCorner {
    Vertex vertex;        ///< for shading: the mesh's own; its position the same bits in all corners that meet here
    glm::vec3 direction;  ///< unit, outwards: what the relief is pressed in along; one for all corners that meet here
    glm::vec2 height_uv;  ///< where this corner reads its height: the uv of the owner of the place
    glm::vec4 edge_uv;    ///< the same along the edge to the next corner: the owner's uv here (xy) and there (zw)
    glm::vec2 spacing;    ///< mean length of the edges that meet in this place: metres, and units of uv
};

/// Counter-clockwise seen from outside. `corners` control points are a patch: 3, or 4 whose places are (0, 0), (1, 0),
/// (1, 1), (0, 1) of the domain.
struct PatchMesh {
    int corners = 3;
    std::vector<PatchCorner> points;  ///< patch i has points[i * corners] and those that follow
    /// Each edge has one partner that runs the other way, and no other; edges without length do not count.
    bool is_closed = false;

    size_t patches() const { return points.size() / size_t(corners); }
};

/// Triangles that touch in one place (positions equal, once what is 1e-12 of the mesh's extent counts as 0) meet there.
/// A direction is the mean of the different normals in a place, each weighted with the angles of its patches; where
/// they cancel out each corner keeps its own normal. For four corners each two triangles in a row that share an edge
/// (and uv and normals along it) are a patch when together they are convex (a fold of up to 60 degrees is); if any pair
/// is not, every triangle is cut into three quads at its middle and the middles of its sides. What has two corners in
/// one place is left out, triangles by themselves and quads of two such. Throws Error when an index has no vertex, the
/// last triangle is not whole, or `corners` is neither 3 nor 4.
PatchMesh make_patches(const Mesh& mesh, int corners);

}  // namespace relief
