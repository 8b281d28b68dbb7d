// Where a view ray meets a relief, as shaders guess it: the searches of labs 10 and 11 in double precision, on the
// exact surface. The twins of shaders/10_parallax_offset/task.glsl and shaders/11_parallax_occlusion/task.glsl.
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "framework/staff/reference/height_field.h"

namespace relief {

/// A view ray in a relief: it enters at `texel` (height 1, t = 0) and reaches the ground (height 0, t = 1) `march`
/// texels further on. `slant` is the cosine between it and the surface's normal.
struct ReliefRay {
    glm::dvec2 texel, march;
    double slant;

    Ray in_texels() const { return {{texel, 1}, {march, -1}}; }
};

/// What is done with the two samples between which the ray has gone below the surface.
enum class Refinement { none, linear, bisection, secant, illinois };
inline constexpr std::array refinement_names = {"none", "linear", "bisection", "secant", "illinois"};

struct ParallaxHit {
    double t;  ///< beyond [0, 1] for the offsets
    glm::dvec2 texel;
    int taps;  ///< heights read
};

/// One tap: as far along the ray as the height at its entry says (Kaneko et al. 2001).
ParallaxHit parallax_offset(const HeightField& field, const ReliefRay& ray);
/// The same without the division by the slant (Welsh 2004): never further than the relief is deep.
ParallaxHit offset_limited(const HeightField& field, const ReliefRay& ray);
/// Layer by layer to the first sample that is not above the surface (McGuire and McGuire 2005).
ParallaxHit steep_parallax(const HeightField& field, const ReliefRay& ray, double steps);

/// `steps` samples along the ray, at least 1 and not always a whole number: the last step is then a shorter one. The
/// last two are refined (linear: Tatarchuk 2006; bisection: Policarpo, Oliveira and Comba 2005; secant: Risser, Shah
/// and Pattanaik 2007; Illinois: Dowell and Jarratt 1971), with `rounds` more samples and one last line between the
/// ends of what is left. `linear` needs no round.
ParallaxHit march(const HeightField& field, const ReliefRay& ray, double steps, Refinement refinement, int rounds);

}  // namespace relief
