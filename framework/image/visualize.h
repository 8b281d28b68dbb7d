// False colours for numbers.
#pragma once

#include <glm/glm.hpp>
#include <utility>

#include "framework/image/compare.h"
#include "framework/image/image.h"

namespace relief {

/// Returns the heat colour of a value: black at 0, then purple and orange, to pale yellow at 1, in stored sRGB. Values
/// are clamped to [0, 1]. The twin of shaders/common/heat.glsl.
glm::dvec3 heat_color(double share);

/// The properties of a probe that determine its colours.
struct ProbeColors {
    ProbeColors(ErrorMetric metric, bool with_sign = false) : error(metric), is_signed(with_sign) {}
    ErrorMetric error;
    bool is_signed;  ///< whether the sign of a value matters
};

/// Returns a probe as an 8-bit picture. Values can be anything. The colours depend on `colors.error`:
/// - angle: directions, as 0.5 v + 0.5.
/// - distance: vectors, in bands whose width is a power of two. Each channel rises from 0 to 1 in every band, like
///   texture coordinates that repeat. A signed channel has no steps. Above 0 it rises from 0.5 to 1 in one band and
///   falls back in the next. Below 0 it falls from 0.5 to 0 and rises back.
/// - absolute: single numbers, on a heat scale that ends at the largest magnitude. Signed numbers below 0 go from black
///   over blue to pale cyan, on the same scale.
///
/// A pixel without a surface (a value is infinite) is dark grey. A pixel of a task that is not written, or with a NaN,
/// is magenta.
Image visualize_probe(const Image& probe, ProbeColors colors);
/// Returns two probes of the same shape in the same colours: both determine the bands and the scale.
std::pair<Image, Image> visualize_probes(const Image& one, const Image& other, ProbeColors colors);

/// Returns a picture as an 8-bit one. Values can be anything: they are clamped to [0, 1]. Infinite and NaN values get
/// the colours of visualize_probe().
Image visualize_picture(const Image& picture);

/// Returns an error image as an 8-bit heat map from black over purple and orange to pale yellow. Errors of `largest`
/// and above get the last colour.
Image visualize_error(const Image& error, double largest);

}  // namespace relief
