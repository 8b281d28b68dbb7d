#include "maps.h"

#include <cmath>
#include <glm/glm.hpp>

#include "framework/core/image/asset.h"

namespace relief::storage {
namespace {

/// Returns the slopes (-dz/dx, -dz/dy) of a dome at p in [-1, 1]², with a flat border.
glm::dvec2 dome(glm::dvec2 p) {
    const double squared = glm::dot(p, p);
    return squared < 0.81 ? p / std::sqrt(1 - squared) : glm::dvec2(0);
}

glm::dvec2 waves(glm::dvec2 p) {
    const glm::dvec2 along(0.8, 0.6);
    return 0.9 * std::sin(9 * glm::dot(along, p)) * along;
}

/// Roofs three texels wide on each side, turned against the grid.
glm::dvec2 ridges(glm::dvec2 p) {
    const glm::dvec2 along(0.96, -0.28);
    const double place = glm::dot(along, p) * 16 / 6;
    return (place - std::floor(place) < 0.5 ? 0.7 : -0.7) * along;
}

/// Returns the normal at p in [-1, 1]². Both halves show the same: a dome above, waves and ridges below.
glm::dvec3 shape_at(glm::dvec2 p) {
    const glm::dvec2 within(2 * (p.x < 0 ? p.x + 1 : p.x) - 1, 2 * p.y + (p.y < 0 ? 1 : -1));
    const glm::dvec2 slopes = p.y >= 0 ? dome(within) : p.y >= -0.5 ? waves(within) : ridges(within);
    return glm::normalize(glm::dvec3(slopes, 1));
}

}  // namespace

Image normal_map(MapName name) {
    Image map(map_size, map_size, 3);
    const Image picture = name == MapName::bricks   ? read_asset("bricks_normal.png")
                          : name == MapName::paving ? read_asset("paving_normal.png")
                                                    : Image();
    const glm::ivec2 corner = name == MapName::bricks ? glm::ivec2(96, 90) : glm::ivec2(200, 200);
    for (int y = 0; y < map_size; ++y)
        for (int x = 0; x < map_size; ++x) {
            const glm::dvec2 place((x + 0.5) / map_size * 2 - 1, 1 - (y + 0.5) / map_size * 2);
            glm::dvec3 normal = shape_at(place);
            if (name != MapName::shapes) {
                const float* color = picture.pixel(corner.x + x, corner.y + y);
                normal = glm::normalize(2.0 * glm::dvec3(color[0], color[1], color[2]) - 1.0);
            }
            for (int c = 0; c < 3; ++c) map.pixel(x, y)[c] = float(normal[c]);
        }
    return map;
}

}  // namespace relief::storage
