// Finds the 8-bit code that stands for 0 in a normal map.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "framework/core/image/image.h"

namespace relief::inspect {

enum class StoredZero {
    half,    ///< round(127.5 n + 127.5)
    paired,  ///< round(127 n) + 128
    cut,     ///< floor(127.5 n + 127.5)
};
inline constexpr std::array zero_names = {"127.5", "128", "127"};

struct ZeroTest {
    size_t colors = 0;            ///< distinct colours of normals that do not point straight up
    std::array<double, 3> rms{};  ///< rms of the length minus 1, under each StoredZero
    std::optional<size_t> best;   ///< the StoredZero that fits; empty if two fit equally well, or none fits
    std::string why;              ///< why `best` is empty
};

/// Finds the zero by length: normals have length 1, so the right zero gives the smallest error over the map's distinct
/// colours. `normals` has 3 or 4 channels with 8-bit values.
ZeroTest test_zero(const Image& normals);

}  // namespace relief::inspect
