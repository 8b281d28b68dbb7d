// SHA-256 (FIPS 180-4): a fingerprint that no other bytes can be made to have.
#pragma once

#include <string>
#include <string_view>

namespace relief {

/// 64 hexadecimal digits, in lower case.
std::string sha256(std::string_view bytes);

}  // namespace relief
