// Groups of corners that share a tangent at a vertex, and the handedness of triangles without area in uv.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "framework/library/mesh/corners.h"
#include "framework/library/mesh/tangent_faces.h"

namespace relief {

/// One corner at a vertex: its triangle's contribution, and the (welded) vertices at the other ends of its two edges.
/// `next` ends the edge that leaves the vertex; `previous` begins the edge that arrives.
struct CornerAtVertex {
    glm::vec3 pull;
    TangentFace face;
    uint32_t next, previous;
    uint32_t group;  ///< index of the group's first corner
};

/// Fills `corners` with the corners in `list`, which are all corners at one vertex. Each starts in a group of its own.
void gather_corners(const Mesh& mesh, const Buffer<uint32_t>& vertex_of, const std::vector<Contribution>& contributions,
                    std::span<const uint32_t> list, std::vector<CornerAtVertex>& corners);

/// Returns whether the triangles of the corners in `list`, which are all corners at one vertex, form one closed ring
/// around it, each joined to the next by an edge. Always false for more than 16 corners.
bool is_closed_fan(const Mesh& mesh, const Buffer<uint32_t>& vertex_of, std::span<const uint32_t> list);

/// Sets `group` by MikkTSpace's rules, see corner_tangents(). The corner of a face without handedness stays alone.
/// `scratch` is working memory, reused from vertex to vertex.
void group_corners(std::span<CornerAtVertex> corners, std::vector<uint64_t>& scratch);

/// Gives each triangle without area in uv the handedness of the first group that it joins, see corner_tangents(). A
/// triangle that joins none keeps 0.
void take_on_handedness(const Mesh& mesh, const Buffer<uint32_t>& vertex_of, const CornerLists& lists,
                        std::vector<Contribution>& contributions);

}  // namespace relief
