#include "maps.h"

#include <cmath>
#include <glm/glm.hpp>

#include "framework/core/image/asset.h"

namespace relief::storage {
namespace {

/// Where a texture of the course has the texels of a map: its upper left one.
glm::ivec2 corner_of(MapName name) { return name == MapName::bricks ? glm::ivec2(96, 90) : glm::ivec2(200, 200); }

/// Returns the centre of a texel in [-1, 1]².
glm::dvec2 place_of(int x, int y) { return {(x + 0.5) / map_size * 2 - 1, 1 - (y + 0.5) / map_size * 2}; }

/// Returns the slopes (-dz/dx, -dz/dy) of a dome at p in [-1, 1]², with a flat border.
glm::dvec2 dome(glm::dvec2 p) {
    const double squared = glm::dot(p, p);
    return squared < 0.81 ? p / std::sqrt(1 - squared) : glm::dvec2(0);
}

constexpr glm::dvec2 along_waves(0.8, 0.6), along_ridges(0.96, -0.28);

glm::dvec2 waves(glm::dvec2 p) { return 0.9 * std::sin(9 * glm::dot(along_waves, p)) * along_waves; }

/// Roofs three texels wide on each side, turned against the grid.
glm::dvec2 ridges(glm::dvec2 p) {
    const double place = glm::dot(along_ridges, p) * 16 / 6;
    return (place - std::floor(place) < 0.5 ? 0.7 : -0.7) * along_ridges;
}

/// Returns p in the coordinates of its quarter of the map, each from -1 to 1.
glm::dvec2 within_quarter(glm::dvec2 p) { return {2 * (p.x < 0 ? p.x + 1 : p.x) - 1, 2 * p.y + (p.y < 0 ? 1 : -1)}; }

/// Returns the normal at p in [-1, 1]². Both halves show the same: a dome above, waves and ridges below.
glm::dvec3 shape_at(glm::dvec2 p) {
    const glm::dvec2 within = within_quarter(p);
    const glm::dvec2 slopes = p.y >= 0 ? dome(within) : p.y >= -0.5 ? waves(within) : ridges(within);
    return glm::normalize(glm::dvec3(slopes, 1));
}

/// Returns the height at p, in the unit of p.
double shape_height(glm::dvec2 p) {
    const glm::dvec2 within = within_quarter(p);
    const double squared = glm::dot(within, within), place = glm::dot(along_ridges, within) * 16 / 6;
    // The quarters are half as wide as their coordinates say.
    if (p.y >= 0) return squared < 0.81 ? 0.5 * (std::sqrt(1 - squared) - std::sqrt(0.19)) : 0;
    if (p.y >= -0.5) return 0.05 + 0.05 * std::cos(9 * glm::dot(along_waves, within));
    return 0.5 * 0.7 * 6 / 16 * std::abs(place - std::floor(place) - 0.5);
}

}  // namespace

Image normal_map(MapName name) {
    Image map(map_size, map_size, 3);
    const Image picture = name == MapName::bricks   ? read_asset("bricks_normal.png")
                          : name == MapName::paving ? read_asset("paving_normal.png")
                                                    : Image();
    const glm::ivec2 corner = corner_of(name);
    for (int y = 0; y < map_size; ++y)
        for (int x = 0; x < map_size; ++x) {
            glm::dvec3 normal = shape_at(place_of(x, y));
            if (name != MapName::shapes) {
                const float* color = picture.pixel(corner.x + x, corner.y + y);
                normal = glm::normalize(2.0 * glm::dvec3(color[0], color[1], color[2]) - 1.0);
            }
            for (int c = 0; c < 3; ++c) map.pixel(x, y)[c] = float(normal[c]);
        }
    return map;
}

Image height_map(MapName name) {
    constexpr double highest_shape = 0.3;
    Image map(map_size, map_size, 1);
    const Image picture = name == MapName::bricks   ? read_asset("bricks_height.png")
                          : name == MapName::paving ? read_asset("paving_height.png")
                                                    : Image();
    const glm::ivec2 corner = corner_of(name);
    for (int y = 0; y < map_size; ++y)
        for (int x = 0; x < map_size; ++x)
            *map.pixel(x, y) = name == MapName::shapes ? float(shape_height(place_of(x, y)) / highest_shape)
                                                       : *picture.pixel(corner.x + x, corner.y + y);
    return map;
}

}  // namespace relief::storage
