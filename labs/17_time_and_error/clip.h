// The visible part of a flat polygon.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace relief {

/// A corner of a polygon: its place in the polygon's plane, and the same in clip space.
struct ClipCorner {
    glm::dvec2 place;
    glm::dvec4 clip;
};

/// Returns the part of a convex polygon that is in the clip volume (Sutherland and Hodgman 1974), empty if there is
/// none. `grown` scales the volume's width and height: 1 is the picture.
std::vector<ClipCorner> clipped(std::vector<ClipCorner> polygon, const glm::dvec2& grown = glm::dvec2(1));

}  // namespace relief
