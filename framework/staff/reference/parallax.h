// The approximate searches of labs 10 and 11 for the intersection of a view ray with a relief, in double precision, on
// the exact surface. Twins of shaders/10_parallax_offset/task.glsl and shaders/11_parallax_occlusion/task.glsl.
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "framework/staff/reference/height_field.h"

namespace relief {

/// A view ray in a relief. It enters at `texel` (height 1, t = 0) and reaches the ground (height 0, t = 1) at `texel +
/// march`. `slant` is the cosine of the angle between the ray and the surface's normal.
struct ReliefRay {
    glm::dvec2 texel, march;
    double slant;

    Ray in_texels() const { return {{texel, 1}, {march, -1}}; }
};

/// Refinement of the hit between the last sample above the surface and the first one on or below it.
enum class Refinement { none, linear, bisection, secant, illinois };
inline constexpr std::array refinement_names = {"none", "linear", "bisection", "secant", "illinois"};

struct ParallaxHit {
    double t;  ///< may lie outside [0, 1] for parallax_offset() and offset_limited()
    glm::dvec2 texel;
    int taps;  ///< number of heights read
};

/// One tap: t = 1 - the height at the entry point (Kaneko et al. 2001).
ParallaxHit parallax_offset(const HeightField& field, const ReliefRay& ray);
/// Parallax offset with offset limiting (Welsh 2004): no division by the slant, so the offset is at most the relief's
/// depth.
ParallaxHit offset_limited(const HeightField& field, const ReliefRay& ray);
/// Returns the first of `steps` layers at which the ray is on or below the surface (steep parallax, McGuire and McGuire
/// 2005).
ParallaxHit steep_parallax(const HeightField& field, const ReliefRay& ray, double steps);

/// Linear search with `steps` samples along the ray, at least 1. If `steps` is not an integer, the last step is
/// shorter. `refinement` then takes `rounds` more samples between the last two, and ends with a linear intersection.
/// `linear` takes no more samples (Tatarchuk 2006). Bisection: Policarpo, Oliveira and Comba 2005; secant: Risser, Shah
/// and Pattanaik 2007; Illinois: Dowell and Jarratt 1971.
ParallaxHit march(const HeightField& field, const ReliefRay& ray, double steps, Refinement refinement, int rounds);

}  // namespace relief
