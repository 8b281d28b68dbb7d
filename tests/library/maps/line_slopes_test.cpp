// Slope filters as tables, compared with their definition.
#include "framework/library/maps/line_slopes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace relief {
namespace {

TEST(SlopeTable, GivesTheSlopesOfEachFilterOnAnyLine) {
    for (const int count : {1, 2, 3, 9})
        for (const bool wrap : {true, false})
            for (const auto& [name, filter] : slope_filters) {
                std::vector<float> line;
                for (int i = 0; i < count; ++i) line.push_back(float(std::sin(1.7 * i) + 0.1 * i));
                SplineLines spline(count, wrap);
                for (int i = 0; i < count; ++i) spline.set(i, &line[size_t(i)], 1, 1);
                spline.solve();
                const Image table = slope_table(filter, count, wrap);
                ASSERT_EQ(table.width, filter == SlopeFilter::spline ? count : 4) << name;
                ASSERT_EQ(table.height, count);
                for (int i = 0; i < count; ++i) {
                    double slope = 0, exact = 0;
                    for (int column = 0; column < table.width; ++column) {
                        const float* const texel = table.pixel(column, count - 1 - i);
                        slope += double(texel[2]) * double(line[size_t(texel[0])] - line[size_t(texel[1])]);
                    }
                    for (const auto& [plus, minus, weight] : slope_differences(filter, i, count, wrap))
                        exact += weight * double(line[size_t(plus)] - line[size_t(minus)]);
                    if (filter == SlopeFilter::spline) exact = spline.slope(i, 0);
                    EXPECT_NEAR(slope, exact, 2e-6) << name << " at " << i << " of " << count << ", wrap " << wrap;
                }
            }
}

}  // namespace
}  // namespace relief
