// The formats of lab 02, and their published errors.
#pragma once

#include <array>

namespace relief::storage {

/// A format with its mean and largest error in degrees, over the sphere, or over the upper hemisphere if z is not
/// stored.
struct Format {
    const char* name;
    const char* title;
    double mean, largest;
    const char* source;  ///< Cigolle et al. 2014; "table" for this project's own errors, over two million directions
};

/// The formats, in the order of sphere.frag.
constexpr std::array<Format, 8> formats = {{{"unorm8", "unorm 8:8:8", 0.1696, 0.3865, "table"},
                                            {"unorm8-truncated", "8:8:8 truncated", 0.3391, 0.7688, "table"},
                                            {"snorm8", "snorm 8:8:8", 0.17015, 0.38588, "Cigolle"},
                                            {"paired8", "8:8:8, 128 is 0", 0.1702, 0.3868, "table"},
                                            {"rg8", "8:8 and z", 0.4671, 5.910, "table"},
                                            {"rg16", "16:16 and z", 0.00298, 0.3577, "table"},
                                            {"oct16", "octahedral 8:8", 0.33709, 0.94424, "Cigolle"},
                                            {"half", "half 16:16:16", 0.00607, 0.0224, "table"}}};

constexpr bool keeps_lower_half(int format) { return format != 4 && format != 5; }

}  // namespace relief::storage
