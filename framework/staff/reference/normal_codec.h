// How a unit normal is stored in few bits, and what comes back.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string_view>

namespace relief {

enum class NormalFormat {
    unorm8,            ///< x, y, z as round(255 (x/2 + 1/2)); 0 cannot be stored: a flat texel tilts by 0.3178 degrees
    unorm8_truncated,  ///< the same without rounding, a common mistake: twice the error
    snorm8,            ///< round(127 x), signed; OpenGL's rule since 4.2: -128 and -127 are both -1
    paired8,           ///< round(127 x) + 128, unsigned: 128 is 0 exactly, if the decoder knows it
    rg8,               ///< x and y as unorm8, z = sqrt(1 - x² - y²): upper hemisphere only, bad near its rim
    rg16,              ///< the same with 16 bits each
    oct8,              ///< octahedral, 2 x 8 bits snorm (Meyer et al. 2010)
    oct8_precise,      ///< oct8, with the best of the four nearest codes (Cigolle et al. 2014)
    oct12,             ///< 2 x 12 bits
    oct12_precise,
    oct16,  ///< 2 x 16 bits
    oct16_precise,
    half,  ///< x, y, z as IEEE half floats
};

struct NormalFormatInfo {
    NormalFormat format;
    std::string_view name;  ///< as on a command line: "oct12-precise"
    int channels;           ///< of a texel
    int bits;               ///< of a channel
};
std::span<const NormalFormatInfo> normal_formats();
const NormalFormatInfo& info_of(NormalFormat format);

/// The stored channels, in the low bits of each number: snorm as two's complement, half as its bit pattern; unused ones
/// are 0. That is what a texture of such a format is filled with.
struct NormalCode {
    std::array<uint16_t, 3> channel{};
    bool operator==(const NormalCode&) const = default;
};

/// Of a direction of any length but 0; one that is zero or not finite counts as (0, 0, 1). rg8 and rg16 lose the sign
/// of z.
NormalCode encode_normal(NormalFormat format, glm::dvec3 normal);

/// The unit vector that a code stands for. To decode with another format than a code was made for is to make a
/// well-known mistake, and gives a unit vector, too; (0, 0, 1) where the channels have no direction.
glm::dvec3 decode_normal(NormalFormat format, NormalCode code);

}  // namespace relief
