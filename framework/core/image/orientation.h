// The orientation that a camera or an editor stores in a picture's EXIF data, in JPEG and PNG.
#pragma once

#include <string_view>

#include "framework/core/image/image.h"

namespace relief {

/// Returns what follows `name` in the first segment of a JPEG file that has this marker and begins with `name`, or
/// nothing. Source: ITU-T T.81, annex B.
std::string_view jpeg_segment(std::string_view bytes, int marker, std::string_view name);

/// Returns the orientation in the bytes of a JPEG or PNG file: 1 (as stored) to 8; 1 if there is none or no such
/// number. Source: Exif 2.32 (CIPA DC-008), tag 274; PNG 3rd edition, chunk eXIf.
int exif_orientation(std::string_view bytes);

/// Returns a picture as it is to be shown: mirrored (2, 4), turned (3, 6, 8), or both (5, 7).
Image oriented(Image stored, int orientation);

}  // namespace relief
