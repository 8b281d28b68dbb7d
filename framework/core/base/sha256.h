// SHA-256 (FIPS 180-4), a collision-resistant hash.
#pragma once

#include <string>
#include <string_view>

namespace relief {

/// Returns 64 hexadecimal digits in lower case.
std::string sha256(std::string_view bytes);

}  // namespace relief
