// A grid around a point, out to the horizon: rings of patches, whose circles have as many vertices as they need.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace relief {

/// A vertex at radius * (sin(angle), cos(angle)). `detail` is a value of its circle.
struct PolarVertex {
    float radius, angle, detail;
};
struct PolarGrid {
    std::vector<PolarVertex> vertices;
    std::vector<unsigned> indices;  ///< triangles
};

/// A circle on which the patches of two rings meet.
struct PolarCircle {
    double radius, detail;
    int segments;  ///< of a patch along the circle, a power of two
};
/// Adds the patch between two circles and the angles `begin` and begin + width, in radians. It has `rows` rows (at
/// least 1). Patches that meet have bit-identical vertices on their common edge.
void add_patch(PolarGrid& grid, const PolarCircle& inner, const PolarCircle& outer, double begin, double width,
               int rows);

/// Returns the edges of triangles, to be drawn as lines. Each triangle has its own.
std::vector<unsigned> edges_of(const std::vector<unsigned>& triangles);

}  // namespace relief
