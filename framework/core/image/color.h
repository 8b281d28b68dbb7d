// The sRGB transfer functions (IEC 61966-2-1), in double precision.
#pragma once

namespace relief {

/// Convert light in [0, 1] to the stored value in [0, 1], and back. Both continue beyond 1, and symmetrically below 0.
double srgb_from_linear(double light);
double linear_from_srgb(double stored);

/// Returns round(255 * srgb_from_linear(light)), clamped to 0..255. NaN gives 0. Fast enough for whole textures,
/// because it computes no power.
unsigned char srgb8_from_linear(float light);
/// Returns linear_from_srgb(stored / 255).
float linear_from_srgb8(unsigned char stored);

}  // namespace relief
