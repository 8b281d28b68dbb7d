// Normal maps in pictures of the user. All labs that take one read it through this file.
#pragma once

#include <string>
#include <vector>

#include "framework/core/image/image.h"

namespace relief {

/// Returns the normal map in a picture with any values: three channels, as 0.5 n + 0.5, with green up and `bits` of the
/// picture. Adds to `notes` what was replaced or is not read. Throws Error without a place for a grey picture.
/// - A texel that holds NaN or infinity becomes (0, 0, 1).
/// - Floats around 0, not around 0.5, are the normals themselves, from -1 to 1.
Image normals_in(const Image& picture, std::vector<std::string>& notes);

}  // namespace relief
