#include "framework/staff/reference/half.h"

#include <cmath>
#include <limits>

namespace relief {

uint16_t half_from_double(double value) {
    const uint16_t sign = std::signbit(value) ? 0x8000 : 0;
    if (std::isnan(value)) return sign | 0x7e00;
    const double size = std::abs(value);
    if (size >= 65520) return sign | 0x7c00;  // halfway between the largest half and the next power of two
    // Halves below 2^-14 are multiples of 2^-24. Above, each power of two holds 2^10 of them.
    int exponent = -14;
    if (size >= 0x1p-14) std::frexp(size, &exponent), --exponent;
    const double steps = std::nearbyint(std::ldexp(size, 10 - exponent));
    // Rounding up to the next power of two carries into the exponent by itself.
    const int stored = size >= 0x1p-14 ? ((exponent + 14) << 10) + int(steps) : int(steps);
    return uint16_t(sign | stored);
}

double double_from_half(uint16_t half) {
    const int exponent = (half >> 10) & 31, fraction = half & 1023;
    double size = std::numeric_limits<double>::infinity();
    if (exponent == 31 && fraction)
        size = std::numeric_limits<double>::quiet_NaN();
    else if (exponent == 0)
        size = std::ldexp(fraction, -24);
    else if (exponent < 31)
        size = std::ldexp(1024 + fraction, exponent - 25);
    return std::copysign(size, half & 0x8000 ? -1.0 : 1.0);
}

}  // namespace relief
