// False colours for numbers.
#pragma once

#include <glm/glm.hpp>
#include <utility>

#include "framework/core/image/compare.h"
#include "framework/core/image/image.h"

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

/// Returns the median magnitude of a probe's values in some of its channels. Ignores zeros and values that are not
/// finite. Returns 1 if no value is left.
double usual_size(const Image& probe, int first_channel = 0, int channels = 3);

/// Returns a probe as an 8-bit picture. No two values of a channel share a colour, except by rounding to 8 bits. Values
/// can be anything. The colours depend on `colors.error`:
/// - angle: directions, as 0.5 v + 0.5.
/// - distance: vectors. Each channel goes from black at its minimum to full brightness at its maximum. In a signed
///   vector, 0 is 0.5.
/// - absolute: single numbers, on a heat scale. Signed numbers below 0 go from black over blue to pale cyan.
///
/// Values other than directions go through a tone curve per channel: (1 + x / L^2) x / (1 + x) with x = |v| / u and
/// L = s / u (Reinhard et al. 2002, equation 4). u is the channel's usual_size(), s its maximum magnitude. The curve
/// rises from 0 at 0 to 1 at s. The curve does not amplify rounding errors: u and s are at least 1e-5 of the probe's
/// maximum magnitude, and a channel within 1e-3 of a constant is bright.
///
/// A pixel without a surface (a value is infinite) is dark grey. A pixel of a task that is not written, or with a NaN,
/// is magenta.
Image visualize_probe(const Image& probe, ProbeColors colors);
/// Returns two probes of the same shape in the same colours. The curve's u comes from `expected`; s, the minimum and
/// the maximum come from both.
std::pair<Image, Image> visualize_probes(const Image& drawn, const Image& expected, ProbeColors colors);

/// Returns a picture as an 8-bit one. Values can be anything: they are clamped to [0, 1]. Infinite and NaN values get
/// the colours of visualize_probe().
Image visualize_picture(const Image& picture);

/// Returns an error image as an 8-bit heat map from black over purple and orange to pale yellow. Errors of `largest`
/// and above get the last colour.
Image visualize_error(const Image& error, double largest);

}  // namespace relief
