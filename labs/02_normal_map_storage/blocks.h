// Normal maps as textures of compressed blocks: BC5, by the encoder of task.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "framework/core/image/image.h"
#include "task.h"

namespace relief::storage {

/// A compressed map as glCompressedTexImage2D takes it: blocks of 4 x 4 texels, row by row from the bottom, each with 8
/// bytes for x and 8 bytes for y.
struct BlockMap {
    int width = 0, height = 0;  ///< texels
    std::vector<uint8_t> bytes;
};

/// Returns the 8 bytes of a channel: both ends, then 48 bits of indices, the lowest bits first. Throws Error if an end
/// or an index is out of its range.
std::array<uint8_t, 8> packed(const ChannelBlock& block, bool is_signed);

/// Compresses x and y of a map of unit normals; z is lost. The ends are signed bytes if `is_signed`, else unsigned ones
/// of (n + 1) / 2. A block at the right or the upper border of a map whose size is not a multiple of 4 repeats the last
/// column or row. So no block has texels of the opposite border. Throws Error, which names the texel, if a normal is
/// not finite.
BlockMap compress(const Image& normals, bool is_signed);

}  // namespace relief::storage
