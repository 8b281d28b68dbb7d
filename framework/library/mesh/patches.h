// Cuts a mesh into patches for tessellation. A relief on them has no cracks, because adjacent patches have the same
// bits for all that they share.
#pragma once

#include <vector>

#include "framework/core/base/mesh.h"

namespace relief {

/// A corner of a patch. A place is a position where corners meet. At a seam or a hard edge, the corners' uv and normals
/// differ, and each would displace the place differently. So each place and each edge has an owner: the first corner or
/// patch that has it. All patches read the height there at the owner's uv (McDonald and Kilgard 2010), and displace a
/// place in one direction. Where nothing differs, these are the vertex's own values.
struct PatchCorner {
    Vertex vertex;        ///< for shading: the mesh's own; the position has the same bits in all corners of a place
    glm::vec3 direction;  ///< unit, outwards: displacement direction, the same for all corners of a place
    glm::vec2 height_uv;  ///< where this corner reads its height: the uv of the place's owner
    glm::vec4 edge_uv;    ///< uv of the edge to the next corner: its owner's uv here (xy) and there (zw)
    glm::vec2 spacing;    ///< mean length of the edges that meet in this place: metres, and units of uv
};

/// Patches of `corners` control points, counter-clockwise seen from outside: 3, or 4 at (0, 0), (1, 0), (1, 1), (0, 1)
/// of the domain.
struct PatchMesh {
    int corners = 3;
    std::vector<PatchCorner> points;  ///< patch i has `corners` points from points[i * corners] on
    /// Whether each edge is shared by exactly two patches, in opposite directions. Edges of zero length do not count.
    bool is_closed = false;

    size_t patches() const { return points.size() / size_t(corners); }
};

/// Cuts a mesh into patches of `corners` points, 3 or 4.
///
/// Corners of equal position meet in a place; before that, coordinates up to 1e-12 of the mesh's extent are rounded to
/// 0. The direction of a place is the mean of its normals, weighted by the patches' angles. Where they cancel out, each
/// corner keeps its own normal.
///
/// With four corners, two consecutive triangles form a patch if they share an edge, with its uv and normals, and are
/// convex together. They may be folded by up to 60 degrees. If any pair forms no patch, every triangle is cut into
/// three quads instead, at its centre and the midpoints of its sides. Drops triangles with two corners in one
/// place, and quads of two such triangles. Throws Error when an index has no vertex, the number of indices is not a
/// multiple of 3, or `corners` is neither 3 nor 4.
PatchMesh make_patches(const Mesh& mesh, int corners);

}  // namespace relief
