// The framework's definition of each slope filter as a table that a shader can read.
#pragma once

#include <algorithm>

#include "framework/height/lines.h"

namespace relief::heights {

/// A row for each texel of a line of `count` (row 0 of the image is the last one), a column for each difference: the
/// two texels and the weight. Unused columns weigh 0. A spline's slope depends on the whole line.
inline Image differences_of_lines(SlopeFilter filter, int count, bool wrap) {
    const auto row = [&](int i) { return count - 1 - i; };
    if (filter != SlopeFilter::spline) {
        Image table(4, count, 3);
        for (int i = 0; i < count; ++i) {
            const SlopeDifferences differences = slope_differences(filter, i, count, wrap);
            for (int k = 0; k < differences.count; ++k) {
                const auto& [plus, minus, weight] = differences.values[size_t(k)];
                std::copy_n(std::array{float(plus), float(minus), float(weight)}.data(), 3, table.pixel(k, row(i)));
            }
        }
        return table;
    }
    // The slopes of a line that is 1 at one texel and 0 elsewhere are a column of weights.
    Image table(count, count, 3);
    std::vector<float> impulse(size_t(count), 0.0f);
    for (int k = 0; k < count; ++k) {
        impulse[size_t(k)] = 1;
        SplineLines lines(count, wrap);
        for (int i = 0; i < count; ++i) lines.set(i, &impulse[size_t(i)], 1, 1);
        lines.solve();
        for (int i = 0; i < count; ++i)
            std::copy_n(std::array{float(k), float(i), float(lines.slope(i, 0))}.data(), 3, table.pixel(k, row(i)));
        impulse[size_t(k)] = 0;
    }
    return table;
}

}  // namespace relief::heights
