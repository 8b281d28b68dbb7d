#include "patch_heights.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "framework/core/base/parallel.h"
#include "framework/core/image/mips.h"

namespace relief {
namespace {

constexpr double steepest = 1e6;
/// Samples per texel. Sides count as 8 texels at least and 64 at most. Edges have more samples because they are cheap.
constexpr int dense_on_edges = 8, dense_inside = 2, fewest_texels = 8, most_texels = 64;

/// A box of uv.
struct Box {
    glm::dvec2 low, high;

    Box(glm::dvec2 a, glm::dvec2 b) : low(glm::min(a, b)), high(glm::max(a, b)) {}
    void take_in(glm::dvec2 uv) { low = glm::min(low, uv), high = glm::max(high, uv); }
    bool holds(const Box& other) const {
        return glm::all(glm::lessThanEqual(low, other.low)) && glm::all(glm::greaterThanEqual(high, other.high));
    }
};

double height_at(const Image& heights, glm::dvec2 uv) {
    const auto wrapped = [](double place, int side) {
        place -= side * std::floor(place / side);
        return place >= 0 && place < side ? place : 0;  // beyond by rounding, or NaN
    };
    const double x = wrapped(uv.x * heights.width - 0.5, heights.width),
                 y = wrapped(uv.y * heights.height - 0.5, heights.height);
    const int left = int(x), right = left + 1 == heights.width ? 0 : left + 1;
    const int below = int(y), above = below + 1 == heights.height ? 0 : below + 1;
    const float* const lower = heights.pixel(0, heights.height - 1 - below);
    const float* const upper = heights.pixel(0, heights.height - 1 - above);
    const double s = x - left, t = y - below;
    return (lower[left] * (1 - s) + lower[right] * s) * (1 - t) + (upper[left] * (1 - s) + upper[right] * s) * t;
}

/// Bounds of the bilinear surface over some cells.
struct Range {
    float lowest = std::numeric_limits<float>::infinity(), highest = -lowest;
    glm::vec2 slope{};  ///< maximum |dh/du| and |dh/dv|

    void take_in(const Range& other) {
        lowest = std::min(lowest, other.lowest), highest = std::max(highest, other.highest);
        slope.x = std::max(slope.x, other.slope.x), slope.y = std::max(slope.y, other.slope.y);
    }
};

/// Cells along one axis, first to last; in two pieces where they wrap around the border.
struct Cells {
    struct Piece {
        int first, last;
    };
    std::array<Piece, 2> pieces;
    int count;
};

/// Cell i is between the centres of texels i and i + 1. Returns all cells where uv are not finite.
Cells cells_between(double from, double to, int side) {
    const double begin = std::floor(from * side - 0.5), count = std::floor(to * side - 0.5) - begin + 1;
    if (!(count < side)) return {{{{0, side - 1}, {0, -1}}}, side};
    const int first = (int(std::fmod(begin, side)) + side) % side, last = first + int(count) - 1;
    return {{{{first, std::min(last, side - 1)}, {0, last - side}}}, int(count)};
}

/// The ranges of a mip level's cells and of blocks of 2x2, 4x4, ... cells, so that any patch reads only a few.
class Ranges {
public:
    explicit Ranges(Image level) : level_(std::move(level)), blocks_{cells_of(level_)} {
        while (blocks_.back().width > 1 || blocks_.back().height > 1) blocks_.push_back(quarters_of(blocks_.back()));
    }

    /// Returns bounds over a box. Heights are exact for a box of up to 8 cells along a side. A longer box is covered
    /// with blocks, at most 9 in a row, which lengthens it by up to a quarter.
    Range within(const Box& box) const {
        const Cells across = cells_between(box.low.x, box.high.x, level_.width),
                    up = cells_between(box.low.y, box.high.y, level_.height);
        int octave = 0;
        while (std::max(across.count, up.count) >> octave > 8) ++octave;
        Range range;
        for (const auto& [bottom, top] : up.pieces)
            for (int y = bottom >> octave; y <= top >> octave; ++y)
                for (const auto& [left, right] : across.pieces)
                    for (int x = left >> octave; x <= right >> octave; ++x)
                        range.take_in(blocks_[size_t(octave)].at(x, y));
        if (octave == 0 && across.count < level_.width && up.count < level_.height)
            std::tie(range.lowest, range.highest) = exactly_within(box, across.count, up.count);
        return range;
    }

private:
    /// Row 0 is the lowest.
    struct Blocks {
        int width, height;
        std::vector<Range> ranges;

        Blocks(int columns, int rows) : width(columns), height(rows), ranges(size_t(columns) * size_t(rows)) {}
        Range& at(int x, int y) { return ranges[size_t(y) * size_t(width) + size_t(x)]; }
        const Range& at(int x, int y) const { return ranges[size_t(y) * size_t(width) + size_t(x)]; }
    };

    /// The extremes over a part of a bilinear cell are at the corners of that part. So only cell borders and box
    /// borders count.
    std::pair<float, float> exactly_within(const Box& box, int columns, int rows) const {
        const glm::dvec2 size(level_.width, level_.height), first = glm::floor(box.low * size - 0.5) + 0.5;
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (int j = 0; j <= rows; ++j)
            for (int i = 0; i <= columns; ++i) {
                const double h = height_at(level_, glm::clamp((first + glm::dvec2(i, j)) / size, box.low, box.high));
                low = std::min(low, h), high = std::max(high, h);
            }
        return {float(low), float(high)};
    }

    static Blocks cells_of(const Image& level) {
        const int width = level.width, height = level.height;
        Blocks cells(width, height);
        for (int y = 0; y < height; ++y) {
            const float* const lower = level.pixel(0, height - 1 - y);
            const float* const upper = level.pixel(0, height - 1 - (y + 1) % height);
            for (int x = 0; x < width; ++x) {
                const int right = (x + 1) % width;
                const auto [low, high] = std::minmax({lower[x], lower[right], upper[x], upper[right]});
                cells.at(x, y) = {
                    low,
                    high,
                    {std::max(std::abs(lower[right] - lower[x]), std::abs(upper[right] - upper[x])) * float(width),
                     std::max(std::abs(upper[x] - lower[x]), std::abs(upper[right] - lower[right])) * float(height)}};
            }
        }
        return cells;
    }

    static Blocks quarters_of(const Blocks& blocks) {
        Blocks result((blocks.width + 1) / 2, (blocks.height + 1) / 2);
        for (int y = 0; y < blocks.height; ++y)
            for (int x = 0; x < blocks.width; ++x) result.at(x / 2, y / 2).take_in(blocks.at(x, y));
        return result;
    }

    Image level_;
    std::vector<Blocks> blocks_;
};

/// Returns an upper bound of the height change per metre, where the height changes by at most `slope` per unit of u and
/// of v. A bilinear difference equals the midpoint derivative times the offset. Let the position have the derivatives a
/// and b at the midpoint, and the height wa and wb. Then the steepest slope there is |wa b - wb a| / |a x b|. Numerator
/// and denominator are bilinear interpolations of their values at the corners. So the quotient is nowhere larger than
/// at the worst corner, provided that each a x b has a positive component along their mean. Otherwise the result is
/// `steepest`.
double steepest_slope(std::span<const HeightCorner> patch, glm::dvec2 slope) {
    const size_t n = patch.size();
    const auto position = [&](size_t i) { return glm::dvec3(patch[i % n].position); };
    const auto uv = [&](size_t i) { return glm::dvec2(patch[i % n].uv); };
    std::array<glm::dvec3, 4> faces;
    glm::dvec3 mean(0);
    for (size_t i = 0; i < n; ++i) {
        faces[i] = glm::cross(position(i + 1) - position(i), position(i + n - 1) - position(i));
        mean += faces[i];
    }
    const double length = glm::length(mean);
    double largest = 0;
    for (size_t i = 0; i < n; ++i)
        for (const double sign : {1.0, -1.0}) {
            const glm::dvec2 gradient(slope.x, sign * slope.y);
            const glm::dvec3 a = position(i + 1) - position(i), b = position(i + n - 1) - position(i);
            const double wa = glm::dot(gradient, uv(i + 1) - uv(i)), wb = glm::dot(gradient, uv(i + n - 1) - uv(i));
            if (wa == 0 && wb == 0) continue;
            const double area = glm::dot(faces[i], mean) / length;
            const double here = glm::length(wa * b - wb * a) / area;
            largest = std::max(largest, area > 0 && here < steepest ? here : steepest);
        }
    return largest;
}

/// Returns the number of samples along a side, a power of two: at least `density` per texel of the longer side of `uv`,
/// where this side counts as fewest_texels to `most` texels.
int cuts_for(glm::dvec2 uv, const Image& heights, int density, int most) {
    const double texels = std::max(std::abs(uv.x) * heights.width, std::abs(uv.y) * heights.height);
    if (!(texels < most)) return density * most;
    return int(std::bit_ceil(unsigned(std::ceil(density * std::max<double>(texels, fewest_texels)))));
}

/// Collects the errors of chords at many samples.
class Offsets {
public:
    void take(double off) {
        if (!(off >= 0)) return;  // NaN
        most_ = std::max(most_, off), squares_ += off * off, ++count_;
    }
    double typical() const {
        const double mean_square = squares_ / double(std::max<size_t>(1, count_));
        return std::max(3 * std::sqrt(mean_square), most_ / 2);
    }

private:
    double most_ = 0, squares_ = 0;
    size_t count_ = 0;
};

/// Returns the error of each level; `error(step)` gives that of the level with a vertex every `step` samples. With
/// one sample between two vertices, a kink near a vertex can be missed; with none, every kink is. So the error is at
/// least half of the level before, which is right for a kink.
template <class Error>
LevelErrors level_errors(int cuts, const Error& error) {
    LevelErrors errors{};
    for (size_t k = 0; k < errors.size(); ++k) {
        const int step = cuts >> k;
        if (step > 1) errors[k] = float(error(step));
        if (step < 4) errors[k] = std::max(errors[k], errors[k - 1] / 2);
    }
    for (size_t k = errors.size() - 1; k-- > 0;) errors[k] = std::max(errors[k], errors[k + 1]);
    return errors;
}

/// Gives the same bits from either end of the edge. Products of floats and dyadic weights are exact in double
/// precision, and a sum of two terms commutes. (The sum of squares may depend on the order in its last bits, which
/// rounding to float hides.)
LevelErrors edge_errors(const Image& heights, glm::vec4 uv, int most, float& middle) {
    const glm::dvec2 begin(uv.x, uv.y), end(uv.z, uv.w);
    const int cuts = cuts_for(end - begin, heights, dense_on_edges, most);
    std::array<float, dense_on_edges * most_texels + 1> samples{};
    for (int i = 0; i <= cuts; ++i) {
        const double t = double(i) / cuts;
        samples[size_t(i)] = float(height_at(heights, begin * (1 - t) + end * t));
    }
    const auto [low, high] = std::minmax_element(samples.begin(), samples.begin() + cuts + 1);
    middle = 0.5f * (*low + *high);
    return level_errors(cuts, [&](int step) {
        const double share = 1.0 / step;
        Offsets off;
        for (int first = 0; first < cuts; first += step)
            for (int i = 1; i < step; ++i) {
                const float* const chord = samples.data() + first;
                const double t = i * share;
                off.take(std::abs(chord[i] - (chord[0] * (1 - t) + chord[step] * t)));
            }
        return off.typical();
    });
}

/// The heights inside a patch, on a grid that contains the vertices of each level.
class Samples {
public:
    LevelErrors errors(const Image& heights, std::span<const HeightCorner> patch, int most) {
        const size_t n = patch.size();
        const auto uv = [&](size_t i) { return glm::dvec2(patch[i % n].uv); };
        const glm::dvec2 a = uv(1) - uv(0), b = uv(n - 1) - uv(0), twist = n == 4 ? uv(2) - uv(1) - b : glm::dvec2(0);
        is_triangle_ = n == 3;
        cuts_ = 0;
        for (size_t i = 0; i < n; ++i)
            cuts_ = std::max(cuts_, cuts_for(uv(i + 1) - uv(i), heights, dense_inside, most));
        for (int j = 0; j <= cuts_; ++j)
            for (int i = 0; i <= (is_triangle_ ? cuts_ - j : cuts_); ++i) {
                const double s = double(i) / cuts_, t = double(j) / cuts_;
                values_[place(i, j)] = float(height_at(heights, uv(0) + s * a + t * b + s * t * twist));
            }
        return level_errors(cuts_, [&](int step) {
            Offsets off;
            for (int j = 0; j < cuts_; j += step)
                for (int i = 0; i < (is_triangle_ ? cuts_ - j : cuts_); i += step) take_cell(i, j, step, off);
            return off.typical();
        });
    }

private:
    size_t place(int i, int j) const { return size_t(j * (cuts_ + 1) + i); }

    /// The chord surface is the plane through three corners plus, beyond the diagonal, a fold that reaches the fourth.
    /// Triangles use the falling diagonal, and have half cells along the side between their last two corners.
    void take_cell(int i, int j, int step, Offsets& off) const {
        const bool is_half = is_triangle_ && i + j + step == cuts_;
        const float low = values_[place(i, j)], right = values_[place(i + step, j)] - low,
                    above = values_[place(i, j + step)] - low;
        const float share = 1 / float(step);
        const float fold = is_half ? 0 : values_[place(i + step, j + step)] - low - right - above;
        for (int v = 0; v <= step; ++v)
            for (int u = 0; u <= (is_half ? step - v : step); ++u) {
                const float s = float(u) * share, t = float(v) * share;
                const float over = values_[place(i + u, j + v)] - (low + s * right + t * above);
                const float one = std::abs(over - fold * std::max(0.0f, s + t - 1));
                off.take(is_triangle_ ? one : std::max(one, std::abs(over - fold * std::min(s, t))));
            }
    }

    static constexpr int longest_row = dense_inside * most_texels + 1;
    int cuts_ = 0;
    bool is_triangle_ = false;
    std::vector<float> values_ = std::vector<float>(size_t(longest_row * longest_row));
};

}  // namespace

int densest_samples(size_t patches) {
    constexpr double most_samples = 64e6;
    int densest = dense_inside * most_texels;
    const auto samples = [](double side) { return (side + 1) * (side + 1) + 4 * (4 * side + 1); };
    while (densest > dense_inside * fewest_texels && double(patches) * samples(densest) > most_samples) densest /= 2;
    return densest;
}

std::vector<PatchHeights> measure_patches(std::span<const HeightCorner> points, int corners, const Image& heights,
                                          bool with_errors) {
    std::vector<Ranges> levels;
    for (Image& level : mip_chain(heights, ColorSpace::linear)) levels.emplace_back(std::move(level));
    const auto range_within = [&](const Box& box) {
        Range range;
        for (const Ranges& level : levels) range.take_in(level.within(box));
        return range;
    };

    std::vector<PatchHeights> result(points.size() / size_t(corners));
    const int most = densest_samples(result.size()) / dense_inside;
    parallel_pieces(result.size(), 8, 0, [&](size_t begin, size_t end) {
        Samples samples;
        for (size_t i = begin; i < end; ++i) {
            const auto patch = points.subspan(i * size_t(corners), size_t(corners));
            Box inside(patch[0].uv, patch[1].uv);
            for (const HeightCorner& corner : patch) inside.take_in(corner.uv);
            Range range = range_within(inside);

            PatchHeights& measured = result[i];
            measured.slope = float(steepest_slope(patch, range.slope));
            if (with_errors) measured.inside = samples.errors(heights, patch, most);
            for (size_t k = 0; k < patch.size(); ++k) {
                const HeightCorner& corner = patch[k];
                if (with_errors)
                    measured.edges[k] = edge_errors(heights, corner.edge_uv, most, measured.edge_heights[k]);
                const glm::vec2 here(corner.edge_uv), there(corner.edge_uv.z, corner.edge_uv.w);
                for (const Box& box : {Box(here, there), Box(corner.height_uv, corner.height_uv)})
                    if (!inside.holds(box)) range.take_in(range_within(box));
            }
            measured.lowest = range.lowest - 1 / 255.0f, measured.highest = range.highest + 1 / 255.0f;
        }
    });
    return result;
}

}  // namespace relief
