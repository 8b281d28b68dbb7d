// IEEE 754 half precision: 1 sign, 5 exponent and 10 fraction bits.
#pragma once

#include <cstdint>

namespace relief {

/// Rounds to the nearest half, ties to even. A magnitude of 65520 or more becomes infinity, 2^-25 or less becomes 0.
/// The sign is kept, and NaN stays NaN.
uint16_t half_from_double(double value);
/// Returns the exact value of a half.
double double_from_half(uint16_t half);

}  // namespace relief
