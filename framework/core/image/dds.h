// Normal maps in DDS files: BC5 (RGTC of two channels, 3Dc), blocks of 4 x 4 texels with 8 bits a texel.
#pragma once

#include <string_view>

#include "framework/core/image/image.h"

namespace relief {

/// The bytes before the first block of a DDS file with a DX10 header, and its DXGI_FORMAT of BC5.
constexpr size_t dds_header_bytes = 148;
constexpr int dxgi_bc5_unorm = 83, dxgi_bc5_snorm = 84;

/// Returns whether bytes begin as a DDS file.
bool is_dds(std::string_view bytes);

/// Returns level 0 of a BC5 texture as a normal map of 3 channels, 0.5 n + 0.5. x and y are the texture's, and z >= 0
/// is rebuilt so that the length is 1; z is 0 if x and y are longer. Row 0 of the file is the top. Throws Error without
/// a place when bytes are missing, the texture is too large, or its format is not BC5.
Image decode_dds(std::string_view bytes);

}  // namespace relief
