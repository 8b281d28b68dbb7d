// Watertight intersection of rays and triangles in double precision (Woop, Benthin and Wald 2013), and the hits of
// whole meshes. The twin of shaders/common/mesh_rays.glsl.
#pragma once

#include <functional>
#include <optional>

#include "framework/core/base/ray.h"
#include "framework/library/mesh/tree.h"

namespace relief {

/// A permutation and shear of the axes for one ray. along[2] is the axis of the direction's largest component. `shear`
/// maps the direction to (0, 0, 1).
struct RayAxes {
    int along[3];
    glm::dvec3 shear;
};
/// Precondition: the direction is finite and not zero.
RayAxes axes_of(const glm::dvec3& direction);

/// Returns (t, weight of corner a, weight of corner b, facing), with t in multiples of the direction. `facing` is 1 if
/// the ray meets the front, where the corners run counter-clockwise, and -1 for the back. All four are 0 for a miss.
/// Two triangles with a shared edge leave no gap under any rounding; a ray through the edge may hit both. A triangle
/// seen edge-on is missed.
glm::dvec4 triangle_hit(const Ray& ray, const RayAxes& axes, const glm::dvec3& a, const glm::dvec3& b,
                        const glm::dvec3& c);

/// Returns whether the ray overlaps the box between t = 0 and `end`. `inverse` is 1 / direction.
bool meets_box(const glm::dvec3& origin, const glm::dvec3& inverse, double end, const glm::dvec3& low,
               const glm::dvec3& high);
/// Returns 1 / direction, with components clamped to [-1e18, 1e18].
glm::dvec3 inverse_direction(const glm::dvec3& direction);

struct MeshHit {
    double t;            ///< in multiples of the ray's direction
    glm::dvec3 weights;  ///< of the triangle's corners; they sum to 1
    uint32_t triangle;
    bool is_front;
};

/// Calls `take` for each hit with t in [0, end], in no particular order.
void each_hit(const TriangleTree& tree, const Mesh& mesh, const Ray& ray, double end,
              const std::function<void(const MeshHit&)>& take);

/// Returns the nearest hit with t in [0, end]. Among hits at equal t it prefers a front face. `front_only` culls back
/// faces.
std::optional<MeshHit> first_hit(const TriangleTree& tree, const Mesh& mesh, const Ray& ray, double end,
                                 bool front_only = false);

/// Returns the interpolated normal of the triangle's corners, with unit length.
glm::dvec3 normal_at(const Mesh& mesh, const MeshHit& hit);

}  // namespace relief
