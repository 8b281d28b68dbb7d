#include "framework/staff/reference/normals.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "framework/core/base/error.h"
#include "framework/core/base/parallel.h"
#include "framework/core/image/color.h"
#include "framework/library/maps/line_slopes.h"
#include "framework/staff/reference/normals_row.h"

namespace relief {
namespace {

/// Larger results do not stay in any cache.
constexpr size_t uncached_bytes = size_t{8} << 20;

/// The slopes of one texel along u and v by the definition, for borders.
class TexelSlopes {
public:
    TexelSlopes(const Image& heights, const NormalOptions& options) : heights_(heights), options_(options) {}

    void write(int x, int y, float* result) const {
        const double du = slope(x, heights_.width, y, heights_.height,
                                [&](int along, int across) { return *heights_.pixel(along, across); });
        const int top = heights_.height - 1;  // lines of v begin at the lowest row
        const double dv = slope(top - y, heights_.height, x, heights_.width,
                                [&](int along, int across) { return *heights_.pixel(across, top - along); });
        const float u = float(options_.texels_u * du), v = float(options_.texels_v * dv);
        normal_of_slope(u, v, result);
    }

private:
    template <class Height>
    double slope(int i, int count, int across, int across_count, Height height) const {
        const SlopeDifferences differences = slope_differences(options_.filter, i, count, options_.wrap);
        const double beside = weight_beside(options_.filter);
        double sum = 0;
        for (int k = -1; k <= 1; ++k) {
            const double weight = k == 0 ? 1 - 2 * beside : beside;
            if (weight == 0) continue;
            const int line = inside(across + k, across_count, options_.wrap);
            for (const SlopeDifference& one : differences)
                sum += weight * one.weight * (double(height(one.plus, line)) - height(one.minus, line));
        }
        return sum;
    }

    const Image& heights_;
    const NormalOptions& options_;
};

/// Weights of the inner loop's differences: of the direct neighbours, and of the neighbours beside or beyond them.
struct InnerWeights {
    double next, side;
};
InnerWeights inner_weights(SlopeFilter filter) {
    if (filter == SlopeFilter::forward) return {1, 0};
    if (filter == SlopeFilter::fourth_order) return {8 / 12.0, -1 / 12.0};
    const double beside = weight_beside(filter);
    return {(1 - 2 * beside) / 2, beside / 2};
}

class Rows {
public:
    /// `normals` holds rows from `first` on.
    Rows(const Image& heights, const NormalOptions& options, Image& normals, int first = 0)
        : heights_(heights), options_(options), normals_(normals), first_(first), texels_(heights, options) {}

    void write(int y) const {
        const int width = heights_.width, height = heights_.height;
        // Where a tap would fall outside, process texels one by one. The rows of a tile wrap by pointer.
        const int reach = options_.filter == SlopeFilter::fourth_order ? 2 : 1;
        const bool row_inside = options_.wrap || (y >= reach && y < height - reach);
        const int begin = std::min(reach, width), end = std::max(begin, width - reach);
        float* const result = normals_.pixel(0, y - first_);
        const bool fast =
            row_inside && end - begin >= normals_row_lanes && write_inside(y, begin, end, result + 3 * begin);
        for (int x = 0; x < (fast ? begin : width); ++x) texels_.write(x, y, result + 3 * x);
        for (int x = fast ? end : width; x < width; ++x) texels_.write(x, y, result + 3 * x);
    }

private:
    bool write_inside(int y, int begin, int end, float* result) const {
        const auto line = [&](int k) { return heights_.pixel(0, inside(y + k, heights_.height, options_.wrap)); };
        const InnerWeights weights = inner_weights(options_.filter);
        const HeightRows rows{.up2 = line(-2),
                              .up = line(-1),
                              .here = line(0),
                              .down = line(1),
                              .down2 = line(2),
                              .u = float(options_.texels_u * weights.next),
                              .v = float(options_.texels_v * weights.next),
                              .u_side = float(options_.texels_u * weights.side),
                              .v_side = float(options_.texels_v * weights.side)};
        return normals_of_row(options_.filter, rows, begin, end, result,
                              normals_.values.size() * sizeof(float) > uncached_bytes);
    }

    const Image& heights_;
    const NormalOptions& options_;
    Image& normals_;
    const int first_;
    TexelSlopes texels_;
};

/// The spline's slopes depend on whole lines: first all columns, then row by row.
void write_spline(const Image& heights, const NormalOptions& options, Image& normals, unsigned threads) {
    constexpr int lanes = spline_lanes;
    const int width = heights.width, height = heights.height;
    Image slopes(width, height, 1);  // dh/dv, rows downwards
    parallel_pieces(size_t((width - 1) / lanes + 1), 1, threads, [&](size_t begin, size_t end) {
        SplineLines columns(height, options.wrap);
        for (int x = int(begin) * lanes; x < std::min(width, int(end) * lanes); x += lanes) {
            const int count = std::min(lanes, width - x);
            for (int y = 0; y < height; ++y) columns.set(y, heights.pixel(x, y), 1, count);
            columns.solve();
            for (int y = 0; y < height; ++y)
                for (int k = 0; k < count; ++k)
                    *slopes.pixel(x + k, y) = float(-options.texels_v * columns.slope(y, k));
        }
    });
    parallel_pieces(size_t((height - 1) / lanes + 1), 1, threads, [&](size_t begin, size_t end) {
        SplineLines rows(width, options.wrap);
        for (int y = int(begin) * lanes; y < std::min(height, int(end) * lanes); y += lanes) {
            const int count = std::min(lanes, height - y);
            for (int x = 0; x < width; ++x) rows.set(x, heights.pixel(x, y), size_t(width), count);
            rows.solve();
            for (int k = 0; k < count; ++k) {
                for (int x = 0; x < width; ++x)
                    normal_of_slope(float(options.texels_u * rows.slope(x, k)), *slopes.pixel(x, y + k),
                                    normals.pixel(x, y + k));
            }
        }
    });
}

}  // namespace

void normals_from_heights(const Image& heights, const NormalOptions& options, Image& normals, unsigned threads) {
    if (heights.channels != 1) throw Error(fmt::format("a height map has one channel; this has {}", heights.channels));
    if (&heights == &normals) throw Error("normals cannot take the place of the heights that they are made from");
    normals.width = heights.width, normals.height = heights.height, normals.channels = 3, normals.bits = 8;
    normals.values.resize(heights.pixel_count() * 3);
    if (heights.pixel_count() == 0) return;

    const bool plain = std::all_of(options.level_strengths.begin(), options.level_strengths.end(),
                                   [](double strength) { return strength == 1; });
    if (!plain) {
        NormalOptions rest = options;
        rest.level_strengths.clear();
        return normals_from_heights(with_level_strengths(heights, options.level_strengths, options.wrap, threads), rest,
                                    normals, threads);
    }
    if (options.filter == SlopeFilter::spline) return write_spline(heights, options, normals, threads);
    const Rows rows(heights, options, normals);
    parallel_pieces(size_t(heights.height), 8, threads, [&](size_t begin, size_t end) {
        for (size_t y = begin; y < end; ++y) rows.write(int(y));
    });
}

void normals_of_rows(const Image& heights, const NormalOptions& options, int first, Image& normals) {
    const Rows rows(heights, options, normals, first);
    parallel_pieces(size_t(normals.height), 8, 0, [&](size_t begin, size_t end) {
        for (size_t y = begin; y < end; ++y) rows.write(first + int(y));
    });
}

Image normals_from_heights(const Image& heights, const NormalOptions& options) {
    Image normals;
    normals_from_heights(heights, options, normals);
    return normals;
}

Image heights_from_color(const Image& color, ColorSpace space) {
    Image heights(color.width, color.height, 1, color.bits);
    const auto light = [&](float stored) { return space == ColorSpace::srgb ? linear_from_srgb(stored) : stored; };
    for (size_t i = 0; i < heights.values.size(); ++i) {
        const float* const pixel = color.values.data() + i * size_t(color.channels);
        const bool grey = color.channels < 3;
        const double luminance =
            grey ? light(pixel[0]) : 0.2126 * light(pixel[0]) + 0.7152 * light(pixel[1]) + 0.0722 * light(pixel[2]);
        heights.values[i] = float(srgb_from_linear(luminance));
    }
    return heights;
}

}  // namespace relief
