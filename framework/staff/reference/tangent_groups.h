// Which corners at one vertex share a tangent.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "framework/staff/reference/tangent_faces.h"

namespace relief {

/// One corner at the vertex that is looked at: its triangle, and the (welded) vertices at the other ends of its edges
/// there, the one that leaves the vertex and the one that arrives.
struct CornerAtVertex {
    const TangentFace* face;
    uint32_t next, previous;
    int8_t handedness;  ///< of the face, or what it takes on
    uint32_t group;     ///< the place of the group's first corner
};

/// Fills in `group` by MikkTSpace's rules, see corner_tangents; corners in no group are alone. Takes on handedness
/// where the face has none and a neighbour has. `scratch` is used again from vertex to vertex.
void group_corners(std::span<CornerAtVertex> corners, std::vector<uint64_t>& scratch);

}  // namespace relief
