// The formulas of lab 08's masks.
#include "framework/staff/reference/masks.h"

#include <gtest/gtest.h>

namespace relief {
namespace {

TEST(Masks, WiresCoverTheirShareOfATileAndTile) {
    constexpr int side = 2000;
    int inside = 0;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const glm::dvec2 uv = (glm::dvec2(x, y) + glm::dvec2(0.31, 0.77)) / double(side);
            inside += is_wire(uv);
            if ((x * 7 + y) % 101 == 0) {
                EXPECT_EQ(is_wire(uv), is_wire(uv + glm::dvec2(3, -2)));
            }
        }
    EXPECT_NEAR(double(inside) / (side * side), wire_coverage, 1e-3);
    EXPECT_TRUE(is_wire({0, 0}));
    EXPECT_FALSE(is_wire({0.5 / wires, 0}));
}

TEST(Masks, LeavesTileHorizontallyAndKeepTheirBordersFree) {
    for (int i = 0; i < 5000; ++i) {
        const glm::dvec2 uv(i * 0.618033988749895, i / 5000.0);
        EXPECT_EQ(leaf_at(uv).has_value(), leaf_at(uv - glm::dvec2(7, 0)).has_value());
        EXPECT_FALSE(leaf_at({uv.x, 0}) || leaf_at({uv.x, 1}));
    }
    EXPECT_GT(leaf_coverage(), 0.2);
    EXPECT_LT(leaf_coverage(), 0.6);
}

}  // namespace
}  // namespace relief
