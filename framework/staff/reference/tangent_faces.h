// What triangles contribute to the tangents at their corners.
#pragma once

#include <cmath>
#include <unordered_map>

#include "framework/mesh/corners.h"
#include "framework/staff/reference/tangents.h"

namespace relief {

/// Unit, of what is so within 1e-6: by one of Newton's steps, without a root.
inline glm::dvec3 made_unit(const glm::dvec3& v) { return v * (1.5 - 0.5 * glm::dot(v, v)); }

/// Unit, or zero where it has no direction.
inline glm::dvec3 direction(const glm::dvec3& v) {
    const double squared = glm::dot(v, v);
    return squared > 0 && std::isfinite(squared) ? v * (1 / std::sqrt(squared)) : glm::dvec3(0);
}

/// The vertices' normals in double precision, of unit length. Those that are zero or not finite are replaced by the
/// mean of their triangles' geometric normals, by area.
class UnitNormals {
public:
    UnitNormals(const Mesh& mesh, const Buffer<uint32_t>& vertex_of, const CornerLists& lists);

    glm::dvec3 at(uint32_t vertex) const;
    /// Of a vertex that stands for those it was welded with.
    bool is_repaired(uint32_t welded) const { return !repaired_.empty() && repaired_.contains(welded); }
    bool are_all_good() const { return repaired_.empty(); }

private:
    const Mesh& mesh_;
    const Buffer<uint32_t>& vertex_of_;
    std::unordered_map<uint32_t, glm::dvec3> repaired_;  // by welded vertex
};

struct TangentFace {
    /// At each corner: the direction of dP/du, as long as the corner's weight; for `mikktspace` on the tangent plane.
    /// Zero where the triangle has none.
    glm::vec3 pull[3];
    int8_t handedness;    ///< the sign of its area in uv; 0 without area, or if it is in no group
    TangentFallback why;  ///< why it has no dP/du: bad uv, no area, not finite
    bool in_no_group;     ///< two corners coincide, or one is not finite: it connects no triangles
};

/// Fills faces[begin] to faces[end - 1]: as many as stay in the nearest cache, at once, by vectors of the widest kind
/// that the processor has. Every kind gives the same bits. For `area` the weights are in units of `area_unit`.
void tangent_faces(const Mesh& mesh, const UnitNormals& normals, TangentMethod method, double area_unit, size_t begin,
                   size_t end, Buffer<TangentFace>& faces);

/// angles[i] = atan2(y[i], x[i]) in [0, pi], for y >= 0; 0 if both are 0. The error is at most 5e-7. Takes many at
/// once: one call of the library's atan2 per angle would cost more than all the rest of a triangle.
void angles_of(const double* y, const double* x, float* angles, int count);

}  // namespace relief
