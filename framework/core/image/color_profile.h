// The colour profiles of picture files. None is applied: maps are numbers as stored, and colours are sRGB. So a profile
// that would change either is named.
#pragma once

#include <string>
#include <string_view>

#include "framework/core/image/image.h"

namespace relief {

/// Returns the name of an ICC profile, or nothing for sRGB's. A profile without a name is "unnamed". Source:
/// ICC.1:2022, sections 7, 9.2.41 and 10.15, and ICC.1:2001-04, section 6.5.17.
std::string icc_profile_name(std::string_view profile);

/// Returns the same for the bytes of a JPEG file. A file without a profile has none.
std::string jpeg_profile_name(std::string_view bytes);

/// Returns a note about Image::profile, or nothing if no value changes: a map's profile may also be linear.
std::string profile_note(const Image& picture, bool is_map);

}  // namespace relief
