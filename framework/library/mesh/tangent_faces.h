// The contribution of each triangle to the tangents at its corners.
#pragma once

#include <cmath>
#include <cstring>
#include <unordered_map>

#include "framework/library/mesh/corners.h"
#include "framework/library/mesh/tangents.h"

namespace relief {

/// Normalises a vector whose length is within 1e-6 of 1: one Newton step, without a root.
inline glm::dvec3 made_unit(const glm::dvec3& v) { return v * (1.5 - 0.5 * glm::dot(v, v)); }

/// Normalises a vector. Returns zero if its squared length is 0 or not finite.
inline glm::dvec3 direction(const glm::dvec3& v) {
    const double squared = glm::dot(v, v);
    return squared > 0 && std::isfinite(squared) ? v * (1 / std::sqrt(squared)) : glm::dvec3(0);
}

/// The vertices' normals in double precision, with unit length. A normal that is zero or not finite is replaced by the
/// area-weighted mean of its triangles' geometric normals.
class UnitNormals {
public:
    UnitNormals(const Mesh& mesh, const Buffer<uint32_t>& vertex_of, const CornerLists& lists);

    glm::dvec3 at(uint32_t vertex) const;
    /// `welded` is the representative of a set of welded vertices.
    bool is_repaired(uint32_t welded) const { return !repaired_.empty() && repaired_.contains(welded); }
    bool are_all_good() const { return repaired_.empty(); }

private:
    const Mesh& mesh_;
    const Buffer<uint32_t>& vertex_of_;
    std::unordered_map<uint32_t, glm::dvec3> repaired_;  // by welded vertex
};

/// What a triangle's corners have in common.
struct TangentFace {
    int8_t handedness;    ///< sign of the area in uv; 0 if that is 0 or if in_no_group
    TangentFallback why;  ///< why it has no dP/du: bad uv, no area, not finite
    bool in_no_group;     ///< two corners coincide, or one is not finite: it connects no triangles
    uint8_t unused;       ///< 0
};

/// A triangle's contribution to the tangent at one of its corners. It is kept in the corner's place in the result,
/// until the vertex is solved: triangles need no memory of their own. xyz is the direction of dP/du times the corner's
/// weight. For `mikktspace` it lies in the tangent plane. It is zero if the triangle has no dP/du. w has the bits of
/// the TangentFace.
using Contribution = glm::vec4;

inline TangentFace face_of(const Contribution& corner) {
    TangentFace face;
    std::memcpy(&face, &corner.w, sizeof face);  // Emscripten 3.1 has no std::bit_cast
    return face;
}
inline float bits_of(const TangentFace& face) {
    float bits = 0;
    std::memcpy(&bits, &face, sizeof bits);
    return bits;
}

/// Fills the three corners of each triangle from `begin` to `end` - 1, in batches that fit in the nearest cache, with
/// the widest vectors of the processor. Every vector width gives the same bits. For `area` the weights are in units of
/// `area_unit`. Returns whether a triangle of a group has no handedness.
bool tangent_faces(const Mesh& mesh, const UnitNormals& normals, TangentMethod method, double area_unit, size_t begin,
                   size_t end, std::vector<Contribution>& corners);

/// Sets angles[i] = atan2(y[i], x[i]) in [0, pi], for y >= 0; 0 if both are 0. The error is at most 5e-7. Vectorised:
/// one call of the library's atan2 per angle would cost more than the rest of a triangle.
void angles_of(const double* y, const double* x, float* angles, int count);

}  // namespace relief
