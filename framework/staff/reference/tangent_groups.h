// Which corners at one vertex share a tangent, and which handedness triangles without area in uv take on.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "framework/mesh/corners.h"
#include "framework/staff/reference/tangent_faces.h"

namespace relief {

/// One corner at the vertex that is looked at: its triangle, and the (welded) vertices at the other ends of its edges
/// there, the one that leaves the vertex and the one that arrives.
struct CornerAtVertex {
    const TangentFace* face;
    uint32_t next, previous;
    uint32_t group;  ///< the place of the group's first corner
};

/// The corners in `list`, all those at one vertex, each in a group of its own.
void gather_corners(const Mesh& mesh, const Buffer<uint32_t>& vertex_of, const Buffer<TangentFace>& faces,
                    std::span<const uint32_t> list, std::vector<CornerAtVertex>& corners);

/// Fills in `group` by MikkTSpace's rules, see corner_tangents; corners of a face without handedness are alone.
/// `scratch` is used again from vertex to vertex.
void group_corners(std::span<CornerAtVertex> corners, std::vector<uint64_t>& scratch);

/// Gives triangles without area in uv the handedness of the first group that they join, see corner_tangents. Those that
/// join none keep 0.
void take_on_handedness(const Mesh& mesh, const Buffer<uint32_t>& vertex_of, const CornerLists& lists,
                        Buffer<TangentFace>& faces);

}  // namespace relief
