// Bounds of the directions that the triangles of a displaced patch can face, whatever the tessellator makes of it.
#pragma once

#include <glm/glm.hpp>
#include <span>

#include "framework/library/mesh/patches.h"
#include "patch_heights.h"

namespace relief {

/// Bounds of the directions that the triangles of a patch can face.
struct Facing {
    glm::dvec4 sphere;  ///< around the corners: centre and radius
    glm::dvec3 axis;    ///< unit: the normal of the patch if it is flat
    double spread;      ///< upper bound of |direction - axis| over the directions of displacement; 2 if unknown
    /// Upper bound of a chord's slope without displacement: its rise along the axis, per metre across the axis.
    double flat_rise;
    /// Upper bounds with displacement, per metre of a chord on the smooth patch of facing_of(). `rise` bounds its rise
    /// along the axis. `shift` bounds its shift across the axis by the remainder of the relief.
    double rise, shift;
    double skew, length;  ///< of the patch's shape: factors by which a thin triangle is steeper than its edges
};

/// Returns the bounds of a patch whose heights lie between `heights.lowest` and `heights.highest` and change by up to
/// `heights.slope` per metre. `scale` is the depth of the relief in metres.
///
/// Let p be the undisplaced patch, E the mean of the lowest and the highest depth, and D the direction of displacement,
/// linear between the corners. The displaced patch is the smooth patch p - E D, which is bilinear, plus a remainder.
/// Between two points the remainder changes by a bounded multiple of their distance on the smooth patch. A bilinear
/// difference equals the midpoint derivative times the offset. Seen along the axis, the derivatives are quotients of
/// bilinear means, so the maximum over the corners bounds them everywhere.
///
/// A triangle is steeper than its edges if its corners are almost collinear. How thin the triangles are follows from
/// their levels. `skew` and `length` add the shape of the patch.
///
/// `flat_rise` and `rise` are infinite if the patch folds over as seen along its axis. `rise` is infinite, too, if an
/// edge or a corner reads heights elsewhere on the map than the inside does.
Facing facing_of(std::span<const PatchCorner> patch, const PatchHeights& heights, double scale);

}  // namespace relief
