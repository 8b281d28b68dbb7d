// SHA-256 (FIPS 180-4): a name for bytes that nobody can give to other bytes.
#pragma once

#include <string>
#include <string_view>

namespace relief {

/// 64 hexadecimal digits, in lower case.
std::string sha256(std::string_view bytes);

}  // namespace relief
