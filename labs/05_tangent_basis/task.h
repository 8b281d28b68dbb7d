// The functions that task.cpp of lab 05 defines: tangents from positions and uv.
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "framework/library/mesh/frame.h"

namespace relief::basis {

struct Triangle {
    std::array<glm::dvec3, 3> position;
    std::array<glm::dvec2, 3> uv;
};

/// The unit directions of dP/du and dP/dv, and the handedness: 1, or -1 if the uv are mirrored. All are zero if the
/// triangle is degenerate in uv.
struct FaceBasis {
    glm::dvec3 tangent{0}, bitangent{0};
    double handedness = 0;
};

/// Returns the basis of a triangle. All of it is zero if the triangle is degenerate, in uv or in space.
FaceBasis solve(const Triangle& triangle);

enum class Weight { uniform, area, angle };

/// Returns the weight of a triangle in the mean at one of its corners (0, 1 or 2).
double corner_weight(Weight weight, const Triangle& triangle, int corner);

/// Returns the tangent of a vertex from the weighted sum of its triangles' tangents. It has unit length, is
/// perpendicular to the unit normal, and has the handedness in w. If the sum is zero or parallel to the normal, it is
/// any perpendicular, as any_perpendicular() in framework/library/mesh/frame.h.
glm::dvec4 vertex_tangent(const glm::dvec3& sum, const glm::dvec3& normal, double handedness);

}  // namespace relief::basis
