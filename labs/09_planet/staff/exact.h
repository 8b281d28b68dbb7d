// The planet of lab 09 in double precision: gradient, normal, grid and first hit.
#pragma once

#include "dual.h"
#include "patches.h"

namespace relief::planet {

/// Returns the height at the unit vector r, in radii, with its gradient on the unit sphere, a tangent vector.
Dual exact_height(const Ground& ground, const glm::dvec3& r);
/// Returns the unit normal of the displaced ground at the unit vector r.
glm::dvec3 exact_normal(const Ground& ground, const glm::dvec3& r);
glm::dvec3 exact_direction(SphereMapping mapping, int face, const glm::dvec2& st);
/// Returns the derivatives of exact_direction() by s and by t.
std::pair<glm::dvec3, glm::dvec3> exact_tangents(SphereMapping mapping, int face, const glm::dvec2& st);
/// Returns the correct rules for splits, skirts and the horizon.
Rules exact_rules();
/// Returns the t in radii at which a ray of unit direction first meets the ground. Returns nothing if it misses, or if
/// it begins below the ground.
std::optional<double> exact_hit(const Shape& shape, const Ray& ray);

}  // namespace relief::planet
