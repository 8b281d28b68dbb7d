#include "framework/library/maps/skips.h"

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

/// Returns 1 - height in 1/255, rounded down. The margin of 1e-3 keeps it conservative where (1 - height) * 255 is
/// rounded up.
uint8_t clear_of(float highest) { return uint8_t(std::max(0.0f, std::floor((1 - highest) * 255 - 1e-3f))); }

/// Clearances of rectangles of blocks: each is the least of four overlapping rectangles that are kept, whose sides are
/// powers of two (Bender and Farach-Colton 2000, on two axes).
class Clearances {
public:
    /// `longest`: of the rectangles' sides, in blocks.
    Clearances(const Grid& blocks, int longest) : width_(blocks.width), height_(blocks.height) {
        const size_t levels = size_t(std::bit_width(unsigned(longest)));
        least_.resize(levels, std::vector<std::vector<uint8_t>>(levels));
        least_[0][0].resize(blocks.values.size());
        std::transform(blocks.values.begin(), blocks.values.end(), least_[0][0].begin(), clear_of);
        for (size_t j = 0; j < levels; ++j) {
            if (j > 0) least_[0][j] = least_of_two(least_[0][j - 1], {0, 1 << (j - 1)});
            for (size_t i = 1; i < levels; ++i) least_[i][j] = least_of_two(least_[i - 1][j], {1 << (i - 1), 0});
        }
    }

    /// Returns the clearance, in 1/255, of `size` blocks from block `from` on. Both axes wrap around.
    uint8_t of(glm::ivec2 from, glm::ivec2 size) const {
        const int i = std::bit_width(unsigned(size.x)) - 1, j = std::bit_width(unsigned(size.y)) - 1;
        const std::vector<uint8_t>& least = least_[size_t(i)][size_t(j)];
        const glm::ivec2 last = from + size - glm::ivec2(1 << i, 1 << j);
        return std::min(std::min(least[at(from)], least[at({last.x, from.y})]),
                        std::min(least[at({from.x, last.y})], least[at(last)]));
    }

private:
    size_t at(glm::ivec2 block) const {
        return size_t(block.y & (height_ - 1)) * size_t(width_) + size_t(block.x & (width_ - 1));
    }
    /// Returns the lesser of each value and the one that is `shift` blocks away.
    std::vector<uint8_t> least_of_two(const std::vector<uint8_t>& values, glm::ivec2 shift) const {
        std::vector<uint8_t> least(values.size());
        for (int y = 0; y < height_; ++y) {
            const uint8_t *const here = &values[at({0, y})], *const there = &values[at({0, y + shift.y})];
            const int wraps = width_ - shift.x % width_;
            uint8_t* const to = &least[at({0, y})];
            for (int x = 0; x < wraps; ++x) to[x] = std::min(here[x], there[x + shift.x % width_]);
            for (int x = wraps; x < width_; ++x) to[x] = std::min(here[x], there[x - wraps]);
        }
        return least;
    }

    int width_, height_;
    std::vector<std::vector<std::vector<uint8_t>>> least_;  ///< sides 2^i and 2^j
};

/// Counts the iterations of the loop of shaders/12_relief_exact/search.glsl with given windows. They are averaged over
/// rays along +u and +v, of all slants and from everywhere on the map, that move farther along `axis`. A ray ends in
/// the first cell whose maximum it comes below, as if that were a hit.
class Turns {
public:
    Turns(const Grid& cells, int block, const Clearances& clearances, int axis)
        : cells_(cells), block_(block), clearances_(clearances) {
        std::mt19937 random(1);
        const auto share = [&] { return double(random()) / 4294967296.0; };
        for (int i = 0; i < 192; ++i) {
            const double turn = std::numbers::pi / 4 * (axis + share()),
                         reach = cells.width * std::pow(2.0, -5.5 + 5.5 * share());
            rays_.push_back({{share() * cells.width, share() * cells.height},
                             {reach * std::cos(turn) + 1e-9, reach * std::sin(turn) + 1e-9}});
        }
    }

    /// Returns the number of iterations of all rays. `extents` are in blocks. Stops counting at `most`.
    int count(const std::vector<glm::ivec2>& extents, int most) const {
        int turns = 0;
        for (const auto& [start, along] : rays_) {
            double t = 0;
            for (int turn = 0; turn < 256 && t < 1; ++turn, ++turns) {
                const glm::ivec2 cell(glm::floor(start + t * along)), block = cell / block_;
                const auto leave = [&, &from = start, &by = along](glm::ivec2 upper) {
                    const glm::dvec2 out = (glm::dvec2(upper) - from) / by;
                    return std::min(out.x, out.y);
                };
                double next = leave(cell + 1);
                if (1 - std::min(next, 1.0) < cells_.wrapped(cell.x, cell.y)) break;
                for (const glm::ivec2 extent : extents) {
                    const double until = clearances_.of(block, 1 + extent) / 255.0;
                    if (until > next) next = std::max(next, std::min(leave(block_ * (block + 1 + extent)), until));
                }
                t = next + 1e-6;
            }
            if (turns >= most) break;
        }
        return turns;
    }

private:
    struct Ray {
        glm::dvec2 start, along;
    };
    const Grid& cells_;
    int block_;
    const Clearances& clearances_;
    std::vector<Ray> rays_;
};

constexpr int longest_extent = 56;  // blocks

/// Chooses windows greedily: each is the one that helps most together with the ones before it. `least`: the map's
/// shorter side in blocks. Returns extents in blocks.
std::array<glm::ivec2, 4> best_windows(const Turns& turns, int least, int axis) {
    std::vector<glm::ivec2> candidates;
    for (const int extent : {0, 1, 2, 3, 5, 7, 10, 14, 20, 28, 40, longest_extent})
        for (const int aside : {0, (extent + 7) / 8, (extent + 1) / 2})
            if (extent < std::max(1, least))
                candidates.push_back(axis == 0 ? glm::ivec2(extent, aside) : glm::ivec2(aside, extent));
    std::array<glm::ivec2, 4> extents{};
    std::vector<glm::ivec2> chosen;
    for (glm::ivec2& best : extents) {
        int fewest = std::numeric_limits<int>::max();
        chosen.emplace_back();
        for (const glm::ivec2 candidate : candidates) {
            chosen.back() = candidate;
            if (const int count = turns.count(chosen, fewest); count < fewest) fewest = count, best = candidate;
        }
        chosen.back() = best;
    }
    return extents;
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
    const Clearances clearances(blocks, 1 + std::min(longest_extent, side / block));
    HeightWindows windows{block, {}, Image(blocks.width, 8 * blocks.height, 4, 8)};
    for (int axis = 0; axis < 2; ++axis) {
        const auto extents = best_windows(Turns(cells, block, clearances, axis), side / block, axis);
        for (size_t k = 0; k < 4; ++k) {
            windows.extent[size_t(axis)][k] = block * extents[k];
            Grid clear(blocks.width, blocks.height);
            for (int y = 0; y < blocks.height; ++y)
                for (int x = 0; x < blocks.width; ++x)
                    clear.row(y)[x] = float(clearances.of({x, y}, 1 + extents[k])) / 255;
            for (int quadrant = 0; quadrant < 4; ++quadrant) {
                const glm::ivec2 behind(quadrant & 1 ? extents[k].x : 0, quadrant & 2 ? extents[k].y : 0);
                for (int y = 0; y < blocks.height; ++y)
                    for (int x = 0; x < blocks.width; ++x)
                        windows.clearance.pixel(x, (8 - 4 * axis - quadrant) * blocks.height - 1 - y)[k] =
                            clear.wrapped(x - behind.x, y - behind.y);
            }
        }
    }
    return windows;
}

glm::mat4 HeightWindows::extents() const {
    glm::mat4 columns;
    for (int k = 0; k < 4; ++k)
        for (int column = 0; column < 4; ++column)
            columns[column][k] = float(extent[size_t(column / 2)][size_t(k)][column % 2]);
    return columns;
}

Image highest_in_5x5(const Image& heights) {
    const Grid cells = highest_in_cells(heights);
    Grid across(cells.width, cells.height), around(cells.width, cells.height);
    const auto pass = [](const Grid& from, Grid& to, glm::ivec2 step) {
        for (int y = 0; y < to.height; ++y)
            for (int x = 0; x < to.width; ++x)
                for (int k = -2; k <= 2; ++k)
                    to.row(y)[x] = std::max(to.row(y)[x], from.wrapped(x + k * step.x, y + k * step.y));
    };
    pass(cells, across, {1, 0});
    pass(across, around, {0, 1});
    return image_of(around);
}

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
