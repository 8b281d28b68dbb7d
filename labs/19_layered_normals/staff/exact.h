// Blends of two normals, three planes of heights, and the variance of averaged normals, in double precision.
// Normals have unit length, z points out of the surface. A slope is (dh/du, dh/dv).
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "framework/core/image/image.h"
#include "settings.h"

namespace relief::layered_normals {

/// Returns the unit normal of a slope.
glm::dvec3 with_slope(glm::dvec2 slope);

/// Returns the blend of two normals, z > 0, by a published formula: linear, overlay of colours, whiteout, UDN, partial
/// derivatives (PD), reoriented normal mapping (RNM; Barré-Brisebois and Hill 2012), or a basis made by a swizzle.
glm::dvec3 blended(Settings::Blend blend, const glm::dvec3& base, const glm::dvec3& detail);

/// Returns the exact normal of a detail on a base. `height` is the detail's, `bend` has the base's second derivatives
/// uu, uv, vv. Both count for Settings::along_normal only.
glm::dvec3 exact_blend(Settings::Question question, const glm::dvec3& base, const glm::dvec3& detail, double height,
                       const glm::dvec3& bend);

/// Returns |n|^sharpness by component, divided by the sum.
glm::dvec3 plane_weights(const glm::dvec3& normal, double sharpness);
/// Returns the gradients of the weights as columns, for the gradients of the normal's components as columns. A weight
/// whose component is 0 has none.
glm::dmat3 weight_gradients(const glm::dvec3& normal, const glm::dmat3& turns, double sharpness);
/// Returns the directions of u and v of a plane, and the outward one, as columns. `side` is 1 or -1.
glm::dmat3 plane_frame(int axis, double side);
/// Returns the normal displaced by a small height along itself, with this gradient.
glm::dvec3 bumped(const glm::dvec3& normal, const glm::dvec3& gradient);

/// Returns the variance of slopes by the length of the mean normal (Toksvig 2005). Infinity for a length of 0.
double lost_variance(const glm::dvec3& mean_normal);
/// Returns the variance of slopes by the differences to two neighbouring pixels, at most 0.09 (Tokuyoshi and
/// Kaplanyan 2019; there it is the squared roughness, twice the variance, and at most 0.18).
double turning_variance(const glm::dvec3& across, const glm::dvec3& up);

/// Returns the highlight of a texel at a slope whose distance from the lobe's middle has the square `spread`, in
/// variances: 1 in the middle. A Gaussian for Blinn-Phong; GGX has a long tail (Walter and others 2007).
double falls(Settings::Brdf brdf, double spread);

/// A map with four channels that repeats, with its mip levels.
class Map {
public:
    explicit Map(const Image& image);
    /// Returns the trilinearly filtered texel; v grows up. Levels are clamped.
    glm::dvec4 at(glm::dvec2 uv, double level) const;

private:
    std::vector<Image> levels_;
};

}  // namespace relief::layered_normals
