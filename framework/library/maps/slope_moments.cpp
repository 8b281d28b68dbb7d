#include "framework/library/maps/slope_moments.h"

#include <algorithm>

namespace relief {

SlopeMaps slope_maps(const Image& normals) {
    SlopeMaps maps{Image(normals.width, normals.height, 2), Image(normals.width, normals.height, 3)};
    for (size_t i = 0; i < normals.pixel_count(); ++i) {
        const float* const stored = &normals.values[3 * i];
        const glm::dvec3 normal = 2.0 * glm::dvec3(stored[0], stored[1], stored[2]) - 1.0;
        const glm::dvec2 slope = -glm::dvec2(normal) / std::max(normal.z, 0.01);
        const glm::dvec3 squares = squares_of(slope);
        for (int c = 0; c < 2; ++c) maps.slopes.values[2 * i + size_t(c)] = float(slope[c]);
        for (int c = 0; c < 3; ++c) maps.squares.values[3 * i + size_t(c)] = float(squares[c]);
    }
    return maps;
}

}  // namespace relief
