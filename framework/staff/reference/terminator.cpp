#include "framework/staff/reference/terminator.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace relief {

double estevez_shadow(const glm::dvec3& surface, const glm::dvec3& mapped, const glm::dvec3& to_light) {
    if (glm::dot(surface, to_light) <= 0) return 0;
    const double c = std::clamp(std::abs(glm::dot(surface, mapped)), 1e-6, 1.0),
                 l = std::clamp(glm::dot(surface, to_light), 1e-6, 1.0);
    const double a = std::min((1 - c * c) / (8 * c * c), 1.0), t = (1 - l * l) / (l * l);
    return 2 / (1 + std::sqrt(1 + a * t));
}

double chiang_shadow(const glm::dvec3& surface, const glm::dvec3& mapped, const glm::dvec3& to_light) {
    const double product = glm::dot(mapped, to_light) * glm::dot(surface, mapped);
    const double g = std::clamp(glm::dot(surface, to_light) / std::max(product, 1e-6), 0.0, 1.0);
    return g * (1 + g * (1 - g));
}

FacetLight schuessler_light(const glm::dvec3& surface, const glm::dvec3& mapped, const glm::dvec3& to_light) {
    const double upright = glm::dot(surface, mapped), above = glm::dot(surface, to_light);
    if (upright <= 0 || above <= 0) return {};
    const glm::dvec3 lean = mapped - upright * surface;
    const double sine = glm::length(lean);
    if (sine == 0) return {above, 0};
    const glm::dvec3 other = -lean / sine;
    const auto visible = [&](const glm::dvec3& way) {
        const double area = std::max(glm::dot(mapped, way), 0.0) + sine * std::max(glm::dot(other, way), 0.0);
        return area > 0 ? std::min(glm::dot(surface, way) * upright / area, 1.0) : 1;
    };
    FacetLight light{std::max(glm::dot(mapped, to_light), 0.0) * visible(to_light), 0};
    const double on_other = glm::dot(other, to_light);
    if (on_other <= 0) return light;
    const glm::dvec3 mirrored = to_light - 2 * on_other * other;
    light.mirrored = std::max(glm::dot(mapped, mirrored), 0.0) * (1 - visible(mirrored)) * visible(to_light);
    return light;
}

std::vector<TileLight> place_lights(const HeightField& heights, double depth, const glm::dvec3& to_light, int samples) {
    std::vector<TileLight> places;
    const glm::dvec3 up(0, 0, 1), in_heights(to_light.x, to_light.y, to_light.z / depth);
    for (int row = 0; row < samples; ++row)
        for (int column = 0; column < samples; ++column) {
            const glm::dvec2 texel = (glm::dvec2(column, row) + 0.5) / double(samples) * glm::dvec2(heights.size());
            const glm::dvec3 normal = glm::normalize(glm::dvec3(-depth * heights.slope(texel), 1));
            const double cosine = glm::dot(normal, to_light), facing = std::max(cosine, 0.0);
            const bool is_lit = cosine > 0 && heights.is_lit(texel, in_heights);
            places.push_back({.clamped = facing,
                              .estevez = facing * estevez_shadow(up, normal, to_light),
                              .chiang = facing * chiang_shadow(up, normal, to_light),
                              .schuessler = schuessler_light(up, normal, to_light).sum(),
                              .flat = to_light.z,
                              .exact = is_lit ? facing : 0,
                              .flux = is_lit ? cosine / normal.z : 0});
        }
    return places;
}

TileLight tile_light(const HeightField& heights, double depth, const glm::dvec3& to_light, int samples) {
    const std::vector<TileLight> places = place_lights(heights, depth, to_light, samples);
    TileLight mean;
    for (double TileLight::*const of :
         {&TileLight::clamped, &TileLight::estevez, &TileLight::chiang, &TileLight::schuessler, &TileLight::flat,
          &TileLight::exact, &TileLight::flux}) {
        for (const TileLight& place : places) mean.*of += place.*of;
        mean.*of /= double(places.size());
    }
    return mean;
}

Image sine_relief(int side) {
    constexpr glm::ivec2 periods[] = {{1, 2}, {2, -1}, {3, 1}, {-1, 3}, {2, 3}, {3, -2}};
    Image image(side, side, 1);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            double sum = 0;
            for (int i = 0; i < 6; ++i) {
                const glm::dvec2 k = glm::dvec2(periods[i]) * (2 * glm::pi<double>() / side);
                sum += std::sin(k.x * x + k.y * (side - 1 - y) + 1.7 * i) / glm::length(glm::dvec2(periods[i]));
            }
            *image.pixel(x, y) = float(0.5 + sum / 8);
        }
    return image;
}

}  // namespace relief
