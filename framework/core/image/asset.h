// Pictures in the course's assets folder, from files that the build makes of them: build/bin/textures/NAME.texels,
// beside the framework's library. Such a file holds a fingerprint of its source picture. When it is missing, damaged or
// of another picture, the picture itself is read, which is slow but always right.
#pragma once

#include <filesystem>
#include <string>

#include "framework/core/image/texels.h"

namespace relief {

/// Returns the picture in assets/NAME. NAME may climb out of that folder with "..". Throws as read_image() does.
Image read_asset(const std::string& name);

/// Returns the picture's mip chain for a colour space, as mip_chain() makes it. Throws as read_image() does.
Texels read_asset_chain(const std::string& name, ColorSpace space);

/// Returns the contents of NAME.texels for the bytes of NAME: its mip chain. A name like stones_albedo.png is averaged
/// as light, any other as plain numbers. Throws as decode_image() does.
std::string convert_asset(const std::string& name, const std::string& bytes);

}  // namespace relief
