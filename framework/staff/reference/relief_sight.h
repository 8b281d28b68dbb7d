// The point of a mesh with a relief that a view ray hits, in double precision: the fragment that the rasteriser would
// make, and the ray's path through the relief from there. As in the shaders, parallax is defined in the fragment's
// tangent plane.
#pragma once

#include <optional>

#include "framework/library/mesh/relief.h"
#include "framework/library/mesh/tree.h"
#include "framework/staff/reference/parallax.h"

namespace relief {

struct ReliefSight {
    double distance;                ///< metres; the ray's direction has unit length
    glm::dvec3 position, normal;    ///< on the triangle; the interpolated normal, normalised
    glm::dvec3 tangent, bitangent;  ///< orthonormal with the normal, by Gram-Schmidt
    glm::dvec2 uv;                  ///< tiles
    ReliefRay ray;                  ///< its slant is at least least_slant
    double metres_to_ground;        ///< along the view ray, from t = 0 to t = 1
    bool faces_away;                ///< the view ray comes from behind the fragment's tangent plane
};

/// The smallest slant (cosine). Flatter view rays are clamped to it: they would cross more tiles than a float can
/// resolve.
constexpr double least_slant = 0.002;

/// Sights of one mesh, which must outlive this object.
class ReliefSights {
public:
    explicit ReliefSights(const Mesh& mesh);
    /// Returns the first triangle that the ray hits, from the distance `begin` on. `front_only` culls back faces.
    std::optional<ReliefSight> look(const Ray& ray, const ReliefMapping& mapping, double begin,
                                    bool front_only = false) const;

private:
    const Mesh& mesh_;
    TriangleTree tree_;
};

}  // namespace relief
