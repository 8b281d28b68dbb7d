// The functions that task.cpp of lab 05 defines: tangents from positions and uv.
#pragma once

#include <array>
#include <glm/glm.hpp>

namespace relief::basis {

struct Triangle {
    std::array<glm::dvec3, 3> position;
    std::array<glm::dvec2, 3> uv;
};

/// Directions of dP/du and dP/dv, of unit length, and the handedness: 1, or -1 where the uv are mirrored. All zero if
/// the triangle has no area in uv.
struct FaceBasis {
    glm::dvec3 tangent{0}, bitangent{0};
    double handedness = 0;
};

FaceBasis solve(const Triangle& triangle);

enum class Weight { uniform, area, angle };

/// The weight of a triangle in the mean at one of its corners (0, 1 or 2).
double corner_weight(Weight weight, const Triangle& triangle, int corner);

/// The tangent of a vertex from the weighted sum of its triangles': of unit length, perpendicular to the normal, the
/// handedness in w. Where the sum has no direction across the normal, any perpendicular will do: framework/mesh/frame.h
/// has one.
glm::dvec4 vertex_tangent(const glm::dvec3& sum, const glm::dvec3& normal, double handedness);

}  // namespace relief::basis
