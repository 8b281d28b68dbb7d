#include "truth.h"

#include "framework/library/kit/drawn_numbers.h"
#include "heights.h"

namespace relief::heights {

Image exact_normals(int size, glm::dvec2 texels) {
    Image image(size, size, 3);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            // The normal is the cross product of the surface's steps of one texel along u and along v.
            const glm::dvec2 rise = slope(centre(x, y, size)) / double(size) * texels;
            const glm::dvec3 normal = glm::normalize(glm::cross(glm::dvec3(1, 0, rise.x), glm::dvec3(0, 1, rise.y)));
            for (int c = 0; c < 3; ++c) image.pixel(x, y)[c] = float(normal[c]);
        }
    return image;
}

std::optional<glm::dvec2> place_on_wall(const Ray& ray, glm::dvec2 wall, double repeat) {
    const double t = -ray.origin.z / ray.direction.z;
    const glm::dvec2 place = glm::dvec2(ray.at(t)) / wall;
    if (!(t > 0) || !(std::abs(place.x) <= 1) || !(std::abs(place.y) <= 1)) return {};
    return glm::fract((place * 0.5 + 0.5) * repeat);
}

Image on_wall(const Frame& frame, const Image& map, glm::dvec2 wall, double repeat) {
    return truth_of_rays(frame, [&](const Ray& ray) -> std::optional<glm::dvec4> {
        const std::optional<glm::dvec2> uv = place_on_wall(ray, wall, repeat);
        if (!uv) return {};
        const int column = std::min(int(uv->x * map.width), map.width - 1);
        const int row = std::min(int(uv->y * map.height), map.height - 1);
        glm::dvec4 value(0);
        for (int c = 0; c < map.channels; ++c) value[c] = double(map.pixel(column, map.height - 1 - row)[c]);
        return value;
    });
}

}  // namespace relief::heights
