// Pictures in the course's assets folder, from what the build made of them: build/bin/textures/NAME.texels, beside the
// framework's library. Such a file knows the bytes that it was made of: where it is missing, broken or of another
// picture, the picture itself is read, which takes time but is never wrong.
#pragma once

#include <filesystem>
#include <string>

#include "framework/image/texels.h"

namespace relief {

/// The picture in assets/NAME. Throws what read_image() throws.
Image read_asset(const std::string& name);

/// Its mip chain for a colour space, by mip_chain().
Texels read_asset_chain(const std::string& name, ColorSpace space);

/// NAME.texels from the bytes of NAME: its mip chain, averaged as light when the name is like stones_albedo.png, else
/// as numbers. Throws what decode_image() throws.
std::string convert_asset(const std::string& name, const std::string& bytes);

}  // namespace relief
