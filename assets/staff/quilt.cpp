#include "assets/staff/quilt.h"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "framework/staff/reference/displaced.h"
#include "framework/staff/reference/tangent_space.h"

namespace relief {
namespace {

constexpr ColumnShape column{.bottom_radius = 0.42f, .top_radius = 0.42f, .height = 1.7f};
constexpr double scale = 0.06;

HeightPoint diamonds(glm::dvec2 uv) {
    const double turn = 2 * glm::pi<double>(), rising = turn * (8 * uv.x + 5 * uv.y),
                 falling = turn * (8 * uv.x - 5 * uv.y);
    return {0.5 + 0.25 * (std::cos(rising) + std::cos(falling)),
            -0.25 * turn *
                glm::dvec2(8 * (std::sin(rising) + std::sin(falling)), 5 * (std::sin(rising) - std::sin(falling)))};
}

void put(Image& map, int x, int y, const glm::dvec3& normal) {
    for (int c = 0; c < 3; ++c) map.pixel(x, y)[c] = float(0.5 * normal[c] + 0.5);
}

}  // namespace

QuiltMaps make_quilt() {
    const glm::dmat3 world_from_object(
        glm::rotate(glm::rotate(glm::dmat4(1), glm::radians(-8.0), {0, 0, 1}), glm::radians(50.0), {0, 1, 0}));
    const Image empty(quilt_texels, quilt_texels, 3, 8);
    QuiltMaps maps{empty, empty, empty};
    for (int y = 0; y < quilt_texels; ++y)
        for (int x = 0; x < quilt_texels; ++x) {
            const glm::dvec2 uv((x + 0.5) / quilt_texels, 1 - (y + 0.5) / quilt_texels);
            const SurfacePoint base = point_on(column, uv);
            const glm::dvec3 normal = displace(base, diamonds(uv), scale).normal;
            put(maps.object, x, y, normal);
            put(maps.world, x, y, world_from_object * normal);
            put(maps.tangent, x, y, to_tangent_space(normal, base.normal, glm::dvec4(base.du, 1)));
        }
    return maps;
}

}  // namespace relief
