// The exact surfaces behind the meshes of framework/library/mesh/shapes.h, in double precision: a point with its
// derivatives, and the first hit of a ray.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "framework/core/base/ray.h"
#include "framework/library/mesh/shapes.h"

namespace relief {

/// A point of a parametric surface P(u, v). u and v are in [0, 1] over the whole shape, as on its mesh but without
/// repetition. `normal` has unit length and points outwards.
struct SurfacePoint {
    glm::dvec3 position, normal;
    glm::dvec3 du, dv;                ///< dP/du, dP/dv
    glm::dvec3 normal_du, normal_dv;  ///< the normal's derivatives
};

/// Returns the tangent at a point: dP/du, made perpendicular to the normal and normalised. NaN where dP/du is 0, as at
/// a sphere's pole.
glm::dvec3 tangent_of(const SurfacePoint& point);

SurfacePoint point_on(const QuadShape& quad, glm::dvec2 place);
SurfacePoint point_on(const ColumnShape& column, glm::dvec2 place);
SurfacePoint point_on(const SphereShape& sphere, glm::dvec2 place);

struct SurfaceHit {
    double t;          ///< in multiples of the ray's direction
    glm::dvec2 place;  ///< u and v, in [0, 1]
};

/// Returns the first hit with t > 0, from outside or inside. The shapes are thin shells: a column has no caps.
std::optional<SurfaceHit> first_hit(const QuadShape& quad, const Ray& ray);
std::optional<SurfaceHit> first_hit(const ColumnShape& column, const Ray& ray);
std::optional<SurfaceHit> first_hit(const SphereShape& sphere, const Ray& ray);

}  // namespace relief
