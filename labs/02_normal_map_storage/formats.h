// The formats of lab 02, and their errors.
#pragma once

#include <array>

namespace relief::storage {

/// A format with its mean and largest error in degrees, over the sphere, or over the upper hemisphere if z is not
/// stored.
struct Format {
    const char* name;
    const char* title;
    double mean, largest;  ///< as in the handout's table
};

/// The formats, in the order of sphere.frag.
constexpr std::array<Format, 8> formats = {{{"unorm8", "unorm 8:8:8", 0.1696, 0.3889},
                                            {"unorm8-truncated", "8:8:8 truncated", 0.3391, 0.7777},
                                            {"snorm8", "snorm 8:8:8", 0.1702, 0.3904},
                                            {"paired8", "8:8:8, 128 is 0", 0.1702, 0.3904},
                                            {"rg8", "8:8 and z", 0.4671, 5.960},
                                            {"rg16", "16:16 and z", 0.00298, 0.3759},
                                            {"oct16", "octahedral 8:8", 0.3371, 0.9570},
                                            {"half", "half 16:16:16", 0.00607, 0.02379}}};

constexpr bool keeps_lower_half(int format) { return format != 4 && format != 5; }

}  // namespace relief::storage
