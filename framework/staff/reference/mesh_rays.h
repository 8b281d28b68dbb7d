// Rays and triangles, watertight, in double precision (Woop, Benthin and Wald 2013). The twin of
// shaders/common/mesh_rays.glsl, and the hits of whole meshes.
#pragma once

#include <functional>
#include <optional>

#include "framework/mesh/ray.h"
#include "framework/mesh/tree.h"

namespace relief {

/// A ray's own axes: along[2] is the largest of its direction. `shear` takes the direction to (0, 0, 1).
struct RayAxes {
    int along[3];
    glm::dvec3 shear;
};
/// The direction is neither zero nor infinite.
RayAxes axes_of(const glm::dvec3& direction);

/// (t, weights of the first and the second corner, facing), t in lengths of the direction: facing is 1 where the ray
/// meets the side from which the corners run counter-clockwise, -1 from the other one, and 0 where it misses; then the
/// rest is 0 as well. Two triangles that share an edge leave no gap between them, whatever is rounded: on the edge the
/// ray may hit both. A triangle seen along its plane is missed.
glm::dvec4 triangle_hit(const Ray& ray, const RayAxes& axes, const glm::dvec3& a, const glm::dvec3& b,
                        const glm::dvec3& c);

/// Whether a part of the ray between t = 0 and `end` is in the box. `inverse` is 1 / direction.
bool meets_box(const glm::dvec3& origin, const glm::dvec3& inverse, double end, const glm::dvec3& low,
               const glm::dvec3& high);
/// 1 / direction, large in place of infinite.
glm::dvec3 inverse_direction(const glm::dvec3& direction);

struct MeshHit {
    double t;            ///< in lengths of the ray's direction
    glm::dvec3 weights;  ///< of the triangle's corners; they sum to 1
    uint32_t triangle;
    bool is_front;
};

/// Calls `take` for each hit with t in [0, end], in no order.
void each_hit(const TriangleTree& tree, const Mesh& mesh, const Ray& ray, double end,
              const std::function<void(const MeshHit&)>& take);

/// The nearest of them; of several as near, one that is seen from its front.
std::optional<MeshHit> first_hit(const TriangleTree& tree, const Mesh& mesh, const Ray& ray, double end);

/// The normals of the triangle's corners, interpolated; unit.
glm::dvec3 normal_at(const Mesh& mesh, const MeshHit& hit);

}  // namespace relief
