// Normal maps as BC5 textures in DDS files, for other programs.
#pragma once

#include <functional>
#include <string>

#include "framework/core/image/image.h"
#include "framework/staff/reference/rgtc.h"

namespace relief {

struct Bc5Options {
    RgtcKind kind = RgtcKind::unorm;
    bool mips = false;  ///< all levels, as normal_mip_chain() makes them; else level 0
    bool best = false;  ///< rgtc_best() in place of rgtc_range_fit(): 2 ms a block
    /// Is called before each part of the work, with its index and the number of parts.
    std::function<void(int part, int parts)> before_part = {};
};

struct Bc5Texture {
    std::string file = {};  ///< a DDS file with a DX10 header; row 0 of the picture is its first
    int levels = 1;
    size_t block_bytes = 0;                        ///< of all levels
    double mean_degrees = 0, largest_degrees = 0;  ///< of level 0, between the map's normals and the decoded ones
};

/// Encodes x and y of a normal map of tangent space: 3 or 4 channels of 0.5 n + 0.5, of which a fourth is ignored.
/// Normals are made unit first. A reader rebuilds z >= 0. Where a side is not a multiple of 4, blocks repeat the last
/// column or row. Throws Error without a place for a map with fewer channels, a texel that is not finite or has no
/// direction, or a normal that points into the surface (z < 0 by more than the rounding of 8 bits).
Bc5Texture encode_bc5(const Image& normals, const Bc5Options& options = {});

}  // namespace relief
