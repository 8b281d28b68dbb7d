// Which corners at a vertex share a tangent, and which handedness is given to triangles without area in uv.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "framework/mesh/corners.h"
#include "framework/staff/reference/tangent_faces.h"

namespace relief {

/// One corner at a vertex: its triangle, and the (welded) vertices at the other ends of the two edges that meet there.
/// `next` ends the edge that leaves the vertex, `previous` begins the edge that arrives.
struct CornerAtVertex {
    const TangentFace* face;
    uint32_t next, previous;
    uint32_t group;  ///< the index of the group's first corner
};

/// Fills `corners` with the corners in `list`, which are all those at one vertex. Each is in a group of its own.
void gather_corners(const Mesh& mesh, const Buffer<uint32_t>& vertex_of, const Buffer<TangentFace>& faces,
                    std::span<const uint32_t> list, std::vector<CornerAtVertex>& corners);

/// Whether the triangles lie around the vertex in one ring, each with the next at an edge. False may also be said of a
/// ring of more than 16.
bool is_closed_fan(std::span<const CornerAtVertex> corners);

/// Fills in `group` by MikkTSpace's rules, see corner_tangents(). The corner of a face without handedness stays alone.
/// `scratch` is working memory, reused from vertex to vertex.
void group_corners(std::span<CornerAtVertex> corners, std::vector<uint64_t>& scratch);

/// Gives each triangle without area in uv the handedness of the first group that it joins, see corner_tangents(). A
/// triangle that joins none keeps 0.
void take_on_handedness(const Mesh& mesh, const Buffer<uint32_t>& vertex_of, const CornerLists& lists,
                        Buffer<TangentFace>& faces);

}  // namespace relief
