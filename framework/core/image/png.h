// PNG by libpng, without the 260 libraries of OpenImageIO.
#pragma once

#include <functional>
#include <string>

#include "framework/core/image/file.h"

namespace relief {

/// Decode and encode PNG as read_image() and encode_image() specify. A palette becomes colours, a transparent colour
/// becomes an alpha channel, and 1, 2 and 4 bits become 8. decode_png() throws Error without a place when bytes are
/// damaged, or the image is larger than read_image() takes.
Image decode_png(const std::string& bytes, Notes& notes);
std::string encode_png(const Image& image, const Notes& notes, ColorSpace space);

/// Returns the values of row y of a picture. They need to stay until the next call only.
using PngRow = std::function<const float*(int y)>;

/// Encodes likewise, but takes the values row by row from the top, and only the shape and the bits from `shape`. So a
/// large picture need not be in memory as a whole.
std::string encode_png(const Image& shape, const Notes& notes, ColorSpace space, const PngRow& row);

}  // namespace relief
