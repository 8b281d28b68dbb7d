// PPM, PGM and PFM, the formats that a pipe between two programs needs no library for.
#pragma once

#include <string>
#include <string_view>

#include "framework/image/image.h"

namespace relief {

/// "P6", 8 bits, three channels; a one-channel image becomes grey, alpha is left out, NaN becomes 0.
std::string encode_ppm(const Image& image);
/// "PF" of 3 channels or "Pf" of 1, little-endian floats; two channels get a third of 0, alpha is left out.
std::string encode_pfm(const Image& image);

/// Whether a file begins like one that decode_netpbm() reads: P5, P6, PF or Pf.
bool is_netpbm(std::string_view bytes);
/// P5 and P6 with 8 or 16 bits (1 or 3 channels, values in [0, 1]), PF and Pf of either byte order, whose scale does
/// not change the values. Throws Error without a place: not this format, cut short, or larger than read_image takes.
Image decode_netpbm(std::string_view bytes);

}  // namespace relief
