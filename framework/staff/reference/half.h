// IEEE 754 half precision: 1 sign, 5 exponent and 10 fraction bits.
#pragma once

#include <cstdint>

namespace relief {

/// The nearest half, ties to even; beyond 65519.99 infinity, below 2^-25 zero. NaN stays NaN.
uint16_t half_from_double(double value);
/// Exact.
double double_from_half(uint16_t half);

}  // namespace relief
