#include "framework/staff/reference/normal_map.h"

#include <algorithm>
#include <cmath>

namespace relief {

glm::dvec3 decode_normal(const glm::dvec3& stored) { return stored * 2.0 - 1.0; }

glm::dvec3 decode_normal_128(const glm::dvec3& stored) { return (stored * 255.0 - 128.0) / 127.0; }

glm::dvec3 decode_normal_xy(const glm::dvec2& xy) { return {xy, std::sqrt(std::max(0.0, 1 - glm::dot(xy, xy)))}; }

glm::dvec3 decode_octahedral(const glm::dvec2& stored) {
    const double z = 1 - std::abs(stored.x) - std::abs(stored.y), below = std::max(-z, 0.0);
    const auto unfolded = [&](double x) { return x >= 0 ? x - below : x + below; };
    return glm::normalize(glm::dvec3(unfolded(stored.x), unfolded(stored.y), z));
}

}  // namespace relief
