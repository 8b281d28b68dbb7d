// PNG by libpng, without the 260 libraries of OpenImageIO.
#pragma once

#include <string>

#include "framework/image/file.h"

namespace relief {

/// As read_image() and encode_image() promise for PNG. A palette becomes colours, one transparent colour an alpha
/// channel, and 1, 2 and 4 bits become 8. Throws Error without a place: damaged, or larger than read_image() takes.
Image decode_png(const std::string& bytes, Notes& notes);
std::string encode_png(const Image& image, const Notes& notes, ColorSpace space);

}  // namespace relief
