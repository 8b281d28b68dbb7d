#include "scales.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "framework/core/base/parallel.h"

namespace relief {
namespace {

constexpr int scale_columns = 2, scale_rows = 4;

/// Returns the height of the uppermost scale at a place. x is in scales from side to side, y in rows. A scale has its
/// root under the two scales above it, and rises towards its tip, two rows below.
double height(double x, double y) {
    const int row = int(std::floor(y));
    double highest = 0;
    for (int i = row; i <= row + 2; ++i) {
        const double middle = i % 2 == 0 ? 0 : 0.5, aside = x - middle - std::round(x - middle);
        const double along = (i + 1 - y) / 2;  // 0 at the root, 1 at the tip
        if (along < 0 || along > 1) continue;
        // Half of the scale's width: constant to about the middle, then round.
        const double rest = std::max(0.0, along - 0.45) / 0.55, half = 0.52 * std::sqrt(std::max(0.0, 1 - rest * rest));
        const double edge = half - std::abs(aside);
        if (edge <= 0) continue;
        const double keel = 0.10 * std::exp(-std::pow(aside / 0.07, 2)), rim = std::min(1.0, edge / 0.09);
        highest =
            std::max(highest, (0.22 + 0.55 * along + keel - 0.75 * aside * aside) * (0.55 + 0.45 * std::sqrt(rim)));
    }
    return highest;
}

}  // namespace

Image make_scales(int texels) {
    Image image(texels, texels, 4, 8);
    constexpr double step = 1.0 / 512, deep = 0.16;  // in tiles; depth of the relief in widths of a scale
    parallel_pieces(size_t(texels), 8, 0, [&](size_t begin, size_t end) {
        for (int y = int(begin); y < int(end); ++y)
            for (int x = 0; x < texels; ++x) {
                const double u = (x + 0.5) / texels, v = 1 - (y + 0.5) / texels;
                const auto at = [&](double du, double dv) {
                    return height((u + du) * scale_columns, (v + dv) * scale_rows);
                };
                const double across = (at(step, 0) - at(-step, 0)) / (2 * step * scale_columns),
                             upwards = (at(0, step) - at(0, -step)) / (2 * step * scale_columns);
                const glm::dvec3 normal = glm::normalize(glm::dvec3(-deep * across, -deep * upwards, 1));
                for (int c = 0; c < 3; ++c) image.pixel(x, y)[c] = float(0.5 + 0.5 * normal[c]);
                image.pixel(x, y)[3] = float(std::clamp(at(0, 0), 0.0, 1.0));
            }
    });
    return image;
}

}  // namespace relief
