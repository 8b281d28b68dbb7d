// Formats that store a unit normal in a few bits: encoding and decoding.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string_view>

namespace relief {

enum class NormalFormat {
    unorm8,            ///< x, y, z as round(255 (x/2 + 1/2)); cannot store 0: a flat texel tilts by 0.3178 degrees
    unorm8_truncated,  ///< the same without rounding, a common mistake: twice the error
    snorm8,            ///< round(127 x), signed; OpenGL's rule since 4.2: -128 and -127 are both -1
    paired8,           ///< round(127 x) + 128, unsigned: 128 is exactly 0 for a decoder that knows the format
    rg8,               ///< x and y as unorm8, z = sqrt(1 - x² - y²): upper hemisphere only, inaccurate near its rim
    rg16,              ///< rg8 with 16 bits per channel
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
    std::string_view name;  ///< on the command line: "oct12-precise"
    int channels;           ///< per texel
    int bits;               ///< per channel
};
std::span<const NormalFormatInfo> normal_formats();
const NormalFormatInfo& info_of(NormalFormat format);

/// The stored channels, as in a texture of the format, in the low bits of each number. snorm is in two's complement,
/// half is a bit pattern. Unused channels are 0.
struct NormalCode {
    std::array<uint16_t, 3> channel{};
    bool operator==(const NormalCode&) const = default;
};

/// Encodes a direction. `normal` can have any length; if it is zero or not finite, (0, 0, 1) is encoded. rg8 and rg16
/// lose the sign of z.
NormalCode encode_normal(NormalFormat format, glm::dvec3 normal);

/// Returns the unit vector of a code; (0, 0, 1) if the channels have no direction. A code of another format also gives
/// a unit vector: a well-known mistake that labs show.
glm::dvec3 decode_normal(NormalFormat format, NormalCode code);

}  // namespace relief
