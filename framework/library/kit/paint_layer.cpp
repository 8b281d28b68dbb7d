#include "framework/library/kit/paint_layer.h"

#include <algorithm>
#include <cmath>

#include "framework/library/maps/resample.h"

namespace relief {

void PaintLayer::add(const Dab& dab, const Image& heights, bool wraps) {
    if (is_empty()) values_ = Image(side, side, 1);
    ++version_;
    const Image before = resampled(heights, side, side);
    const auto height_at = [&](int x, int y) {
        const auto inside = [&](int i) { return wraps ? (i % side + side) % side : std::clamp(i, 0, side - 1); };
        return double(*before.pixel(inside(x), inside(y)));
    };
    const glm::dvec2 middle(dab.place.x * side, (1 - dab.place.y) * side);  // row 0 is the top
    const double radius = std::max(dab.radius * side, 0.5);
    const int reach = std::min(int(std::ceil(radius)) + 1, side / 2);
    for (int down = -reach; down <= reach; ++down)
        for (int right = -reach; right <= reach; ++right) {
            const int x = int(std::floor(middle.x)) + right, y = int(std::floor(middle.y)) + down;
            const double distance = glm::length(glm::dvec2(x, y) + 0.5 - middle) / radius;
            const bool is_inside = x >= 0 && x < side && y >= 0 && y < side;
            if (distance >= 1 || (!is_inside && !wraps)) continue;
            const double share = (1 - distance * distance) * (1 - distance * distance);
            double change = dab.strength * share;
            if (dab.kind == Dab::lower) change = -change;
            if (dab.kind == Dab::smooth) {
                double mean = 0;
                for (int i = 0; i < 25; ++i) mean += height_at(x + i % 5 - 2, y + i / 5 - 2) / 25;
                change *= mean - height_at(x, y);
            }
            // A height at its limit takes no more paint, so that the other brush acts at once.
            const double old = height_at(x, y);
            *values_.pixel((x + side) % side, (y + side) % side) += float(std::clamp(old + change, 0.0, 1.0) - old);
        }
}

Image PaintLayer::on(const Image& heights) const {
    if (is_empty()) return heights;
    Image painted = heights;
    const Image layer = resampled(values_, heights.width, heights.height);
    for (size_t i = 0; i < painted.values.size(); ++i)
        painted.values[i] = std::clamp(painted.values[i] + layer.values[i], 0.0f, 1.0f);
    return painted;
}

}  // namespace relief
