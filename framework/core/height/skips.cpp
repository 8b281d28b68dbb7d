#include "framework/core/height/skips.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>
#include <numbers>
#include <random>

#include "framework/core/base/error.h"
#include "framework/core/base/parallel.h"

namespace relief {
namespace {

/// One value per cell or per block, row 0 lowest.
struct Grid {
    int width, height;
    std::vector<float> values;

    Grid(int columns, int rows) : width(columns), height(rows), values(size_t(columns) * size_t(rows)) {}
    float* row(int y) { return values.data() + size_t(y) * size_t(width); }
    const float* row(int y) const { return values.data() + size_t(y) * size_t(width); }
    float wrapped(int x, int y) const { return row(y & (height - 1))[x & (width - 1)]; }
};

void require_powers_of_two(const Image& heights) {
    if (heights.channels != 1 || !std::has_single_bit(unsigned(heights.width)) ||
        !std::has_single_bit(unsigned(heights.height)))
        throw Error(fmt::format(
            "a height map that repeats has one channel and sides that are powers of two; this is {}x{} with {}",
            heights.width, heights.height, heights.channels));
}

Grid highest_in_cells(const Image& heights) {
    require_powers_of_two(heights);
    Grid cells(heights.width, heights.height);
    const auto texels = [&](int y) { return heights.pixel(0, heights.height - 1 - (y & (heights.height - 1))); };
    for (int y = 0; y < cells.height; ++y) {
        const float *const lower = texels(y), *const upper = texels(y + 1);
        for (int x = 0; x < cells.width; ++x) {
            const int right = (x + 1) & (cells.width - 1);
            cells.row(y)[x] = std::max(std::max(lower[x], lower[right]), std::max(upper[x], upper[right]));
        }
    }
    return cells;
}

/// Replaces each value by the maximum of `length` values, from itself on, wrapping around.
void slide(std::vector<float>& values, int length) {
    const int count = int(values.size());
    length = std::min(length, count);
    int reach = 1;
    std::vector<float> next(values.size());
    while (reach < length) {  // windows double in length; the last one overlaps
        const int shift = std::min(reach, length - reach);
        for (int i = 0; i < count; ++i)
            next[size_t(i)] = std::max(values[size_t(i)], values[size_t((i + shift) % count)]);
        values.swap(next);
        reach += shift;
    }
}

/// Returns the maximum of each block of `side` x `side` cells.
Grid highest_in_blocks(const Grid& cells, int side) {
    if (side == 1) return cells;
    Grid blocks(cells.width / side, cells.height / side);
    parallel_pieces(size_t(blocks.height), 16, 0, [&](size_t begin, size_t end) {
        for (int y = int(begin) * side; y < int(end) * side; ++y) {
            float* const to = blocks.row(y / side);
            for (int x = 0; x < cells.width; ++x)
                to[x / side] = std::max(y % side == 0 && x % side == 0 ? 0.0f : to[x / side], cells.row(y)[x]);
        }
    });
    return blocks;
}

/// Returns for each cell the maximum of the `side` x `side` cells that begin `behind` cells before it on both axes.
Grid highest_in_squares(const Grid& cells, int behind, int side) {
    Grid across(cells.width, cells.height), result(cells.width, cells.height);
    parallel_pieces(size_t(cells.height), 32, 0, [&](size_t begin, size_t end) {
        for (int y = int(begin); y < int(end); ++y) {
            std::vector<float> line(cells.row(y), cells.row(y) + cells.width);
            slide(line, side);
            for (int x = 0; x < cells.width; ++x) across.row(y)[x] = line[size_t((x - behind) & (cells.width - 1))];
        }
    });
    parallel_pieces(size_t(cells.width), 32, 0, [&](size_t begin, size_t end) {
        std::vector<float> line;
        for (int x = int(begin); x < int(end); ++x) {
            line.resize(size_t(cells.height));
            for (int y = 0; y < cells.height; ++y) line[size_t(y)] = across.row(y)[x];
            slide(line, side);
            for (int y = 0; y < cells.height; ++y) result.row(y)[x] = line[size_t((y - behind) & (cells.height - 1))];
        }
    });
    return result;
}

glm::ivec2 behind(int quadrant, int extent) { return {quadrant & 1 ? extent : 0, quadrant & 2 ? extent : 0}; }

/// Returns 1 - height in 1/255, rounded down. The margin of 1e-3 keeps it conservative where (1 - height) * 255 is
/// rounded up.
float clear_of(float highest) { return std::max(0.0f, std::floor((1 - highest) * 255 - 1e-3f)); }

/// Counts the iterations of the loop of shaders/12_relief_exact/search.glsl with given windows. They are averaged over
/// rays of all slants from everywhere on the map. A ray ends in the first cell whose maximum it comes below, as if that
/// were a hit.
class Turns {
public:
    struct Window {
        int extent;
        Grid highest;  ///< maxima of the squares that begin at each block, for rays along +u and +v
    };
    Turns(const Grid& cells, int block) : cells_(cells), block_(block) {
        std::mt19937 random(1);
        const auto share = [&] { return double(random()) / 4294967296.0; };
        for (int i = 0; i < 384; ++i) {
            const double turn = std::numbers::pi / 2 * share(),
                         reach = cells.width * std::pow(2.0, -5.5 + 5.5 * share());
            rays_.push_back({{share() * cells.width, share() * cells.height},
                             {reach * std::cos(turn) + 1e-9, reach * std::sin(turn) + 1e-9}});
        }
    }

    double mean(const std::vector<const Window*>& windows) const {
        int64_t turns = 0;
        for (const auto& [start, along] : rays_) {
            double t = 0;
            for (int turn = 0; turn < 256 && t < 1; ++turn, ++turns) {
                const glm::ivec2 cell(glm::floor(start + t * along)), block = cell & ~(block_ - 1);
                const auto leave = [&, &from = start, &by = along](glm::ivec2 upper) {
                    const glm::dvec2 out = (glm::dvec2(upper) - from) / by;
                    return std::min(out.x, out.y);
                };
                double next = leave(cell + 1);
                if (1 - std::min(next, 1.0) < cells_.wrapped(cell.x, cell.y)) break;
                for (const Window* window : windows) {
                    const double highest = window->highest.wrapped(block.x / block_, block.y / block_);
                    next = std::max(next, std::min(leave(block + block_ + window->extent), 1 - highest));
                }
                t = next + 1e-6;
            }
        }
        return double(turns) / double(rays_.size());
    }

private:
    struct Ray {
        glm::dvec2 start, along;
    };
    const Grid& cells_;
    int block_;
    std::vector<Ray> rays_;
};

/// Chooses windows greedily: each is the one that helps most together with the ones before it. `blocks` holds the
/// maxima of `block` x `block` cells.
std::array<int, 4> best_windows(const Grid& cells, const Grid& blocks, int block) {
    std::vector<Turns::Window> candidates;
    for (const int extent : {0, 1, 2, 3, 5, 7, 10, 14, 20, 28, 40, 56})
        if (extent == 0 || (extent < std::min(blocks.width, blocks.height) && extent * block <= 56))
            candidates.push_back({extent * block, highest_in_squares(blocks, 0, 1 + extent)});
    const Turns turns(cells, block);
    std::array<int, 4> extent{};
    std::vector<const Turns::Window*> chosen;
    for (int& size : extent) {
        const Turns::Window* best = nullptr;
        double fewest = std::numeric_limits<double>::infinity();
        chosen.push_back(nullptr);
        for (const Turns::Window& candidate : candidates) {
            chosen.back() = &candidate;
            if (const double mean = turns.mean(chosen); mean < fewest) fewest = mean, best = &candidate;
        }
        chosen.back() = best, size = best->extent;
    }
    std::sort(extent.begin(), extent.end());
    return extent;
}

Image image_of(const Grid& grid) {
    Image image(grid.width, grid.height, 1);
    for (int y = 0; y < grid.height; ++y) std::copy_n(grid.row(y), grid.width, image.pixel(0, grid.height - 1 - y));
    return image;
}

}  // namespace

HeightWindows height_windows(const Image& heights) {
    const Grid cells = highest_in_cells(heights);
    const int side = std::min(cells.width, cells.height), block = side < 512 ? 1 : std::max(2, side / 512);
    const Grid blocks = highest_in_blocks(cells, block);
    HeightWindows windows{block, best_windows(cells, blocks, block), Image(blocks.width, 4 * blocks.height, 4, 8)};
    for (int k = 0; k < 4; ++k) {
        // A window in another quadrant is the quadrant-0 window of a shifted block.
        const int extent = windows.extent[size_t(k)] / block;
        const Grid ahead = highest_in_squares(blocks, 0, 1 + extent);
        for (int quadrant = 0; quadrant < 4; ++quadrant)
            for (int y = 0; y < blocks.height; ++y)
                for (int x = 0; x < blocks.width; ++x) {
                    const glm::ivec2 from = glm::ivec2(x, y) - behind(quadrant, extent);
                    windows.clearance.pixel(x, (4 - quadrant) * blocks.height - 1 - y)[k] =
                        clear_of(ahead.wrapped(from.x, from.y)) / 255;
                }
    }
    return windows;
}

Image highest_in_5x5(const Image& heights) { return image_of(highest_in_squares(highest_in_cells(heights), 2, 5)); }

Image cone_map(const Image& heights, unsigned threads) {
    const Grid cells = highest_in_cells(heights);
    Grid cones(cells.width, cells.height);
    const int reach = std::min(cone_reach, std::max(1, cells.width / 2));
    parallel_pieces(size_t(cells.height), 1, threads, [&](size_t begin, size_t end) {
        for (int y = int(begin); y < int(end); ++y)
            for (int x = 0; x < cells.width; ++x) {
                const float top = cells.row(y)[x];
                // Nothing is known beyond the reach, so the cone must end there at height 1.
                float widest = top < 1 ? float(reach) / (1 - top) : cone_widest;
                for (int ring = 1; ring <= reach; ++ring) {
                    if (float(ring - 1) >= widest * (1 - top)) break;
                    for (int along = -ring; along <= ring; ++along)
                        for (const auto& [dx, dy] :
                             {std::pair(along, -ring), {along, ring}, {-ring, along}, {ring, along}}) {
                            const float rise = cells.wrapped(x + dx, y + dy) - top;
                            if (rise <= 0) continue;
                            const float gap_x = float(std::max(0, std::abs(dx) - 1)),
                                        gap_y = float(std::max(0, std::abs(dy) - 1));
                            widest = std::min(widest, std::sqrt(gap_x * gap_x + gap_y * gap_y) / rise);
                        }
                }
                cones.row(y)[x] = std::min(widest, cone_widest);
            }
    });
    return image_of(cones);
}

}  // namespace relief
