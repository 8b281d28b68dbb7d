#include "framework/staff/reference/ambient_occlusion.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>

#include "framework/core/base/parallel.h"

namespace relief {

double open_share(double h1, double h2, double g) {
    const double quarter = glm::half_pi<double>();
    h1 = std::max(h1, g - quarter), h2 = std::min(h2, g + quarter);
    const auto half = [g](double h) { return -std::cos(2 * h - g) + std::cos(g) + 2 * h * std::sin(g); };
    return (half(h1) + half(h2)) / 4;
}

Image occlusion_from_heights(const Image& heights, double texels, int slices, int reach,
                             const std::function<void(int part, int parts)>& before_part) {
    const int width = heights.width, height = heights.height;
    const auto at = [&](int x, int y) {
        return texels * double(*heights.pixel((x % width + width) % width, (y % height + height) % height));
    };
    const auto between = [&](glm::dvec2 place) {
        const glm::dvec2 low = glm::floor(place), part = place - low;
        const int x = int(low.x), y = int(low.y);
        return glm::mix(glm::mix(at(x, y), at(x + 1, y), part.x), glm::mix(at(x, y + 1), at(x + 1, y + 1), part.x),
                        part.y);
    };
    Image open(width, height, 1);
    const auto find_row = [&](int y) {
        for (int x = 0; x < width; ++x) {
            const double here = at(x, y);
            const glm::dvec2 slope = glm::dvec2(at(x + 1, y) - at(x - 1, y), at(x, y + 1) - at(x, y - 1)) / 2.0;
            const glm::dvec3 normal = glm::normalize(glm::dvec3(-slope, 1));
            double sum = 0;
            for (int slice = 0; slice < slices; ++slice) {
                const double turn = glm::pi<double>() * slice / slices;
                const glm::dvec2 way(std::cos(turn), std::sin(turn));
                const glm::dvec2 within(glm::dot(glm::dvec2(normal), way), normal.z);
                double horizons[2];
                for (int side = 0; side < 2; ++side) {
                    double steepest = 0;
                    for (int step = 1; step <= reach; step += 1 + step / 4)
                        steepest = std::max(
                            steepest, (between(glm::dvec2(x, y) + way * double(side ? step : -step)) - here) / step);
                    horizons[side] = std::atan2(1, steepest);
                }
                sum += glm::length(within) * open_share(-horizons[0], horizons[1], std::atan2(within.x, within.y));
            }
            *open.pixel(x, y) = float(std::clamp(sum / slices, 0.0, 1.0));
        }
    };
    constexpr int rows_of_part = 32;
    const int parts = (height + rows_of_part - 1) / rows_of_part;
    for (int part = 0; part < parts; ++part) {
        if (before_part) before_part(part, parts);
        const int first = part * rows_of_part;
        parallel_each(size_t(std::min(rows_of_part, height - first)), 0,
                      [&](size_t row) { find_row(first + int(row)); });
    }
    return open;
}

}  // namespace relief
