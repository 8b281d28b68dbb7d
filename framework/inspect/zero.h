// Which number of 8 bits stands for 0 in a normal map.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "framework/image/image.h"

namespace relief {

enum class StoredZero {
    half,    ///< round(127.5 n + 127.5)
    paired,  ///< round(127 n) + 128
    cut,     ///< floor(127.5 n + 127.5)
};
inline constexpr std::array zero_names = {"127.5", "128", "127"};

struct ZeroTest {
    size_t colors = 0;            ///< different ones, that are not straight up
    std::array<double, 3> rms{};  ///< of the length less 1, by each StoredZero
    std::optional<size_t> best;   ///< the StoredZero that fits; none when two fit alike, or none does
    std::string why;              ///< there is none
};

/// A normal's length is 1, so the zero with which the lengths of the map's different colours are off least is the one
/// that it was stored with. 3 or 4 channels with values of 8 bits.
ZeroTest test_zero(const Image& normals);

}  // namespace relief
