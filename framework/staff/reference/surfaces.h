// The shapes of framework/mesh/shapes.h as the surfaces that their meshes stand for, in double precision: a place on
// them with its derivatives, and where a ray meets them first.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "framework/mesh/ray.h"
#include "framework/mesh/shapes.h"

namespace relief {

/// A place of a parametric surface P(u, v), u and v in [0, 1] over the whole shape, with u and v as on its mesh but not
/// repeated. `normal` has unit length and points outwards.
struct SurfacePoint {
    glm::dvec3 position, normal;
    glm::dvec3 du, dv;                ///< dP/du, dP/dv
    glm::dvec3 normal_du, normal_dv;  ///< how the normal turns
};

/// The tangent of a SurfacePoint: dP/du made orthonormal to the normal. Where dP/du is 0 (at a sphere's
/// pole) it is not a number.
glm::dvec3 tangent_of(const SurfacePoint& point);

SurfacePoint point_on(const QuadShape& quad, glm::dvec2 place);
SurfacePoint point_on(const ColumnShape& column, glm::dvec2 place);
SurfacePoint point_on(const SphereShape& sphere, glm::dvec2 place);

struct SurfaceHit {
    double t;          ///< in lengths of the ray's direction
    glm::dvec2 place;  ///< u and v, in [0, 1]
};

/// The first place with t > 0 where the ray meets the surface, from outside or from inside (the shapes are thin: a
/// column has no caps).
std::optional<SurfaceHit> first_hit(const QuadShape& quad, const Ray& ray);
std::optional<SurfaceHit> first_hit(const ColumnShape& column, const Ray& ray);
std::optional<SurfaceHit> first_hit(const SphereShape& sphere, const Ray& ray);

}  // namespace relief
