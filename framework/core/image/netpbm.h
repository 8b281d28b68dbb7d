// PPM, PGM and PFM: formats that programs can pipe to each other without a library.
#pragma once

#include <string>
#include <string_view>

#include "framework/core/image/image.h"

namespace relief {

/// Encodes as "P6" with 8 bits and three channels. One or two channels give grey of the first, alpha is dropped, and
/// NaN becomes 0.
std::string encode_ppm(const Image& image);
/// Encodes as "PF" (3 channels) or "Pf" (1 channel) with little-endian floats. A two-channel image gets a third channel
/// of 0; a fourth channel is dropped.
std::string encode_pfm(const Image& image);

/// Returns whether bytes begin like a format of decode_netpbm(): P5, P6, PF or Pf.
bool is_netpbm(std::string_view bytes);
/// Decodes P5 and P6 with 8 or 16 bits (1 or 3 channels, values in [0, 1]), and PF and Pf of either byte order. The
/// scale of PF and Pf does not change the values. Throws Error without a place for another format, truncated bytes, or
/// an image larger than read_image() takes.
Image decode_netpbm(std::string_view bytes);

}  // namespace relief
