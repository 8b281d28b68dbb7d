// Maps for skipping: a search never skips anything that it could hit.
#include "framework/library/maps/skips.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/glm.hpp>
#include <random>

#include "framework/core/base/error.h"
#include "framework/library/maps/test_maps.h"

namespace relief {
namespace {

/// Brute-force maximum of each cell: cell (x, y) has texels (x, y) to (x + 1, y + 1), row 0 lowest.
class Cells {
public:
    explicit Cells(const Image& heights) : heights_(heights) {}
    float height(int x, int y) const {
        const auto wrapped = [](int i, int n) { return ((i % n) + n) % n; };
        return *heights_.pixel(wrapped(x, heights_.width), heights_.height - 1 - wrapped(y, heights_.height));
    }
    float top(int x, int y) const {
        return std::max(std::max(height(x, y), height(x + 1, y)), std::max(height(x, y + 1), height(x + 1, y + 1)));
    }
    float top(int x, int y, int width, int rows) const {
        float highest = 0;
        for (int j = 0; j < rows; ++j)
            for (int i = 0; i < width; ++i) highest = std::max(highest, top(x + i, y + j));
        return highest;
    }

private:
    const Image& heights_;
};

Image random_heights(int width, int height) {
    std::mt19937 random(7);
    Image image(width, height, 1);
    for (float& value : image.values) value = float(random() % 1000) / 999.0f * (random() % 8 == 0 ? 1.0f : 0.3f);
    return image;
}

std::vector<Image> maps_with_peaks() {
    return {make_height_map(HeightMap::stones, 64), make_height_map(HeightMap::posts, 64), random_heights(32, 16),
            random_heights(1, 1), random_heights(2, 8)};
}

/// Returns where the window of an octant begins for a block whose first cell is (x, y).
glm::ivec2 first_of(int x, int y, int octant, glm::ivec2 extent) {
    return {x - (octant & 1 ? extent.x : 0), y - (octant & 2 ? extent.y : 0)};
}

TEST(HeightSkips, WindowClearancesAreTightUpperBounds) {
    std::vector<Image> all = maps_with_peaks();
    all.push_back(make_height_map(HeightMap::stones, 512));  // has larger blocks, of which some are tested
    for (const Image& map : all) {
        const int step = map.width < 512 ? 1 : 61;
        const Cells cells(map);
        const HeightWindows windows = height_windows(map);
        const int columns = map.width / windows.block, rows = map.height / windows.block;
        ASSERT_EQ(windows.clearance.width, columns);
        ASSERT_EQ(windows.clearance.height, 8 * rows);
        ASSERT_EQ(windows.block, map.width < 512 ? 1 : 2);
        for (int octant = 0; octant < 8; ++octant)
            for (int y = 0; y < rows; y += step)
                for (int x = 0; x < columns; x += step)
                    for (int k = 0; k < 4; ++k) {
                        const glm::ivec2 extent = windows.extent[size_t(octant / 4)][size_t(k)];
                        const glm::ivec2 size = windows.block + extent;
                        const auto from = first_of(x * windows.block, y * windows.block, octant, extent);
                        const float highest = cells.top(from.x, from.y, size.x, size.y);
                        const float clearance = windows.clearance.pixel(x, (8 - octant) * rows - 1 - y)[k];
                        ASSERT_LE(clearance, 1 - highest) << map.width << ": " << x << ", " << y << ", " << k;
                        ASSERT_GT(clearance, 1 - highest - 2.0f / 255)
                            << map.width << ": " << x << ", " << y << ", " << k;
                    }
    }
}

TEST(HeightSkips, TheFiveByFiveMaximumCoversTheSurroundingCells) {
    for (const Image& map : maps_with_peaks()) {
        const Cells cells(map);
        const Image around = highest_in_5x5(map);
        for (int y = 0; y < map.height; ++y)
            for (int x = 0; x < map.width; ++x)
                ASSERT_EQ(*around.pixel(x, map.height - 1 - y), cells.top(x - 2, y - 2, 5, 5));
    }
}

TEST(HeightSkips, ConesContainNoCell) {
    for (const Image& map : maps_with_peaks()) {
        const Cells cells(map);
        const Image cones = cone_map(map);
        for (int y = 0; y < map.height; ++y)
            for (int x = 0; x < map.width; ++x) {
                const float cone = *cones.pixel(x, map.height - 1 - y), foot = cells.top(x, y);
                ASSERT_GE(cone, 0);
                for (int dy = -map.height; dy <= map.height; ++dy)
                    for (int dx = -map.width; dx <= map.width; ++dx) {
                        const float gap =
                            std::hypot(float(std::max(0, std::abs(dx) - 1)), float(std::max(0, std::abs(dy) - 1)));
                        const float rise = cells.top(x + dx, y + dy) - foot;
                        if (rise > 0) {
                            ASSERT_LE(cone * rise, gap * 1.0001f + 1e-5f) << map.width << ": " << x << ", " << y;
                        }
                    }
            }
    }
}

TEST(HeightSkips, WindowsFitTheMap) {
    // Posts are one texel wide, every sixteen texels: no window with more than fourteen cells along both axes is empty.
    for (const auto& extents : height_windows(make_height_map(HeightMap::posts, 256)).extent)
        for (const glm::ivec2 extent : extents) EXPECT_LE(std::min(extent.x, extent.y), 13);
    // A window for rays along an axis is longer along that axis.
    const auto stones = height_windows(make_height_map(HeightMap::stones, 256)).extent;
    for (int k = 0; k < 4; ++k) {
        EXPECT_GE(stones[0][size_t(k)].x, stones[0][size_t(k)].y);
        EXPECT_GE(stones[1][size_t(k)].y, stones[1][size_t(k)].x);
    }
}

TEST(HeightSkips, RejectASideThatIsNotAPowerOfTwo) {
    EXPECT_THROW(height_windows(Image(3, 4, 1)), Error);
    EXPECT_THROW(cone_map(Image(4, 6, 1)), Error);
    EXPECT_THROW(height_windows(Image(4, 4, 3)), Error);
}

}  // namespace
}  // namespace relief
