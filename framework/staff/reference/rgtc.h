// RGTC, the compression of one or two channels in OpenGL 3.0 and later (BC4, BC5, 3Dc), in double precision: a decoder
// by the specification, range fit, and the best encoding of a block.
#pragma once

#include <array>
#include <cstdint>

namespace relief {

/// The meaning of the 8-bit ends: unsigned ones of [0, 1], or signed ones of [-1, 1].
enum class RgtcKind { unorm, snorm };

/// One channel of a block of 4 x 4 texels. Texel (x, y) is element x + 4 y; row 0 is the first in memory.
struct RgtcBlock {
    int first = 0, second = 0;      ///< 0 to 255; or -128 to 127 if signed, where -128 and -127 are both -1
    std::array<int, 16> indices{};  ///< 0 to 7
    bool operator==(const RgtcBlock&) const = default;
};

/// Returns the block in the layout of the specification: both ends, then the indices of texels 0 to 15 with 3 bits
/// each, the lowest bits first. Precondition: all members are in their ranges.
std::array<uint8_t, 8> rgtc_bytes(const RgtcBlock& block);
/// The inverse of rgtc_bytes().
RgtcBlock rgtc_block(const std::array<uint8_t, 8>& bytes, RgtcKind kind);

/// Returns the values that the indices 0 to 7 stand for. If first > second, indices 2 to 7 divide the range from first
/// to second into 7 equal steps. Else indices 2 to 5 divide it into 5 steps, 6 is the minimum of the format (0 or -1),
/// and 7 the maximum, 1. (OpenGL 4.1, appendix C.1)
std::array<double, 8> rgtc_ramp(int first, int second, RgtcKind kind);

std::array<double, 16> rgtc_decode(const RgtcBlock& block, RgtcKind kind);

// The encoders take values in [0, 1], or in [-1, 1] if signed. Values outside are clamped. They throw Error if a value
// is NaN.

/// Returns the block with the rounded maximum as its first end, the rounded minimum as its second, and the nearest
/// index for each texel.
RgtcBlock rgtc_range_fit(const std::array<double, 16>& values, RgtcKind kind);

/// Returns a block with the smallest possible sum of squared errors. Tries all pairs of ends, of which either may be
/// greater, so both modes are searched. Ties go to the first pair found.
RgtcBlock rgtc_best(const std::array<double, 16>& values, RgtcKind kind);

/// Returns the sum of squared errors of a block.
double rgtc_squared_error(const RgtcBlock& block, const std::array<double, 16>& values, RgtcKind kind);

}  // namespace relief
