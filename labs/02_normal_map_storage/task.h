// The function that task.cpp of lab 02 defines: one channel of a compressed block.
#pragma once

#include <array>

namespace relief::storage {

/// One channel of a block of BC5: 4 x 4 texels, row by row from the bottom.
struct ChannelBlock {
    int first = 0, second = 0;      ///< the ends: 0 to 255, or -127 to 127 in a signed texture
    std::array<int, 16> indices{};  ///< 0 to 7, one for each texel
};

/// Encodes the 16 values of a channel. They are finite and in steps of the texture: 0 to 255, or -127 to 127 if it is
/// signed. They are not rounded.
ChannelBlock encode_channel(const std::array<double, 16>& values);

}  // namespace relief::storage
