// Numbers as colours, for people.
#pragma once

#include <glm/glm.hpp>
#include <utility>

#include "framework/image/compare.h"
#include "framework/image/image.h"

namespace relief {

/// Black at 0 over purple and orange to pale yellow at 1, as sRGB stores it. The twin of shaders/common/heat.glsl.
glm::dvec3 heat_color(double share);

/// What of a probe chooses its colours.
struct ProbeColors {
    ProbeColors(ErrorMetric metric, bool with_sign = false) : error(metric), is_signed(with_sign) {}
    ErrorMetric error;
    bool is_signed;  ///< whether it matters that a value is above or below 0
};

/// A probe as an 8-bit picture: directions (compared by angle) as 0.5 v + 0.5; vectors (by distance) in bands a power of
/// two wide, each channel rising from 0 to 1 in every band, as texture coordinates repeat; single numbers as a heat map,
/// the largest being the last colour. Of what is signed, a vector rises from a half to 1 in one band above 0 and falls
/// back in the next, without a step; below 0 it falls from a half to 0 and rises back. Single numbers below 0 go from
/// black over blue to pale cyan, as far as those above 0 go to yellow. Dark grey where there is no surface (a value is
/// infinite), magenta where a task is not written or it is not a number. Values can be anything.
Image visualize_probe(const Image& probe, ProbeColors colors);
/// Two of one shape in the same colours: bands and heat are chosen by what is in either.
std::pair<Image, Image> visualize_probes(const Image& one, const Image& other, ProbeColors colors);

/// A picture whose values can be anything, as an 8-bit one: what is below 0 or above 1 is cut, and colours are those of
/// visualize_probe() where a value is infinite or not a number.
Image visualize_picture(const Image& picture);

/// An error image as an 8-bit heat map from black over purple and orange to pale yellow, `largest` and more
/// being the last.
Image visualize_error(const Image& error, double largest);

}  // namespace relief
