// The planet of lab 09 in double precision: gradient, normal, grid and first hit.
#pragma once

#include "patches.h"
#include "dual.h"

namespace relief::planet {

/// In radii, with its gradient on the unit sphere: tangent to it.
Dual exact_height(const Ground& ground, const glm::dvec3& r);
/// Of the displaced ground, of unit length.
glm::dvec3 exact_normal(const Ground& ground, const glm::dvec3& r);
glm::dvec3 exact_direction(Mapping mapping, int face, const glm::dvec2& st);
/// Its derivatives by s and by t.
std::pair<glm::dvec3, glm::dvec3> exact_tangents(Mapping mapping, int face, const glm::dvec2& st);
/// Split distance, skirts and horizon.
Rules exact_rules();
/// The first t at which a ray (of unit length) from above the ground meets it, radii. Nothing from below it.
std::optional<double> exact_hit(const Shape& shape, const Ray& ray);

}  // namespace relief::planet
