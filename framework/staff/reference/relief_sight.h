// What a ray sees of a mesh with a relief, in double precision: the fragment that the rasteriser would make, and the
// view ray in the relief from there. Parallax is defined in the fragment's own tangent plane, as the method is.
#pragma once

#include <optional>
#include <vector>

#include "framework/mesh/mesh.h"
#include "framework/mesh/relief.h"
#include "framework/staff/reference/parallax.h"

namespace relief {

struct ReliefSight {
    double distance;                ///< in lengths of the ray's direction, which is normalised
    glm::dvec3 position, normal;    ///< on the triangle; the interpolated normal, normalised
    glm::dvec3 tangent, bitangent;  ///< unit and at right angles, by Gram-Schmidt
    glm::dvec2 uv;                  ///< tiles
    ReliefRay ray;                  ///< the slant is at least least_slant
    double metres_to_ground;        ///< along the view ray, from t = 0 to t = 1
    bool faces_away;                ///< the view ray comes from behind the fragment's tangent plane
};

/// A view ray that is flatter counts as no flatter: it would pass more tiles than a float can tell apart.
constexpr double least_slant = 0.002;

class ReliefSights {
public:
    explicit ReliefSights(const Mesh& mesh);
    /// The first triangle that the ray meets (Möller and Trumbore 1997), from either side, or from the front alone as
    /// where back faces are culled.
    std::optional<ReliefSight> look(const Ray& ray, const ReliefMapping& mapping, bool front_only = false) const;

private:
    struct Triangle {
        glm::dvec3 corner, e1, e2;
    };
    const Mesh& mesh_;
    std::vector<Triangle> triangles_;
};

}  // namespace relief
