// The framework's slope filters as tables that a shader can read.
#pragma once

#include <algorithm>

#include "framework/core/height/lines.h"

namespace relief::heights {

/// Returns the differences of a filter as an image with a row for each texel of a line of `count` texels. Row 0 is the
/// last texel. A column holds one difference: its two texels and its weight, which is 0 in unused columns. There are 4
/// columns; a spline has `count`, because its slope depends on the whole line.
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
    // Column k holds the slopes of an impulse: the line that is 1 at texel k and 0 elsewhere.
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
