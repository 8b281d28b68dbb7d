// The sRGB transfer functions (IEC 61966-2-1), in double precision.
#pragma once

namespace relief {

/// Light in [0, 1] to the stored value in [0, 1], and back. Both are continued beyond 1 and by symmetry below
/// 0.
double srgb_from_linear(double light);
double linear_from_srgb(double stored);

/// round(255 * srgb_from_linear(light)), clamped to 0..255, without a power: for whole textures.
unsigned char srgb8_from_linear(float light);
/// linear_from_srgb(stored / 255).
float linear_from_srgb8(unsigned char stored);

}  // namespace relief
