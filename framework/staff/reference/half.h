// IEEE 754 half precision: 1 sign, 5 exponent and 10 fraction bits.
#pragma once

#include <cstdint>

namespace relief {

/// Rounds to the nearest half, ties to even. 65520 and more become infinity, 2^-25 and less zero. NaN stays NaN.
uint16_t half_from_double(double value);
/// The exact value.
double double_from_half(uint16_t half);

}  // namespace relief
