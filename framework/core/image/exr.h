// OpenEXR as this course writes it, without OpenImageIO: one image of 32-bit floats, in scan lines with ZIP
// compression.
#pragma once

#include <optional>
#include <string>

#include "framework/core/image/file.h"

namespace relief {

/// Encodes 1 to 4 channels (Y, YA, RGB or RGBA) as encode_image() specifies. Source of the format: the technical
/// introduction and the file layout of the OpenEXR project (Academy Software Foundation).
std::string encode_exr(const Image& image, const Notes& notes);

/// Returns the image of a file like those of encode_exr(), from any program. Returns nothing if the file uses another
/// part of the format, such as tiles, halves or other compressions. Throws Error without a place when bytes are
/// damaged. Precondition: the header is complete, its values are not larger than the file, and no side exceeds
/// max_image_side.
std::optional<Image> decode_plain_exr(const std::string& bytes, Notes& notes);

}  // namespace relief
