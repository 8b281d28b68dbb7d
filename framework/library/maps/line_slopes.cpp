#include "framework/library/maps/line_slopes.h"

#include <algorithm>
#include <cmath>

#include "framework/core/base/parallel.h"

namespace relief {

int inside(int index, int count, bool wrap) {
    if (!wrap) return std::clamp(index, 0, count - 1);
    const int rest = index % count;
    return rest < 0 ? rest + count : rest;
}

SlopeDifferences slope_differences(SlopeFilter filter, int i, int count, bool wrap) {
    SlopeDifferences result;
    const auto add = [&](int plus, int minus, double weight) {
        result.values[size_t(result.count++)] = {inside(plus, count, wrap), inside(minus, count, wrap), weight};
    };
    const bool fourth = filter == SlopeFilter::fourth_order || filter == SlopeFilter::spline;
    const int from_end = std::min(i, count - 1 - i);
    const int in = i < count - 1 - i ? 1 : -1;  // direction into the line, from the nearer end

    if (filter == SlopeFilter::forward) {
        if (wrap || i + 1 < count)
            add(i + 1, i, 1);
        else
            add(i, i - 1, 1);
    } else if (fourth && (wrap || from_end >= 2)) {
        add(i + 1, i - 1, 8 / 12.0);
        add(i + 2, i - 2, -1 / 12.0);
    } else if (fourth && count >= 5 && from_end == 1) {
        add(i - in, i, in * -3 / 12.0);
        add(i + in, i, in * 18 / 12.0);
        add(i + 2 * in, i, in * -6 / 12.0);
        add(i + 3 * in, i, in * 1 / 12.0);
    } else if (fourth && count >= 5) {
        add(i + in, i, in * 48 / 12.0);
        add(i + 2 * in, i, in * -36 / 12.0);
        add(i + 3 * in, i, in * 16 / 12.0);
        add(i + 4 * in, i, in * -3 / 12.0);
    } else if (wrap || from_end >= 1) {
        add(i + 1, i - 1, 0.5);
    } else if (count >= 3) {
        add(i + in, i, in * 2.0);
        add(i + 2 * in, i, in * -0.5);
    } else {
        add(i + 1, i - 1, 1);  // the only difference of a line of two; 0 on a line of one
    }
    return result;
}

double weight_beside(SlopeFilter filter) {
    if (filter == SlopeFilter::sobel) return 1 / 4.0;
    return filter == SlopeFilter::scharr ? 3 / 16.0 : 0;
}

SplineLines::SplineLines(int count, bool wrap)
    : wrap_(wrap), values_(static_cast<size_t>(count)), work_(static_cast<size_t>(count)) {
    // Thomas algorithm: m(i) + factor(i) m(i+1) = ..., with the same factors for all lines.
    double factor = 0;
    for (int i = 0; i < count; ++i) factors_.push_back(factor = 1 / (4 - factor));
}

void SplineLines::set(int i, const float* heights, size_t stride, int lanes) {
    Lanes& to = values_[size_t(i)];
    for (int k = 0; k < lanes; ++k) to[size_t(k)] = heights[size_t(k) * stride];
    for (int k = lanes; k < spline_lanes; ++k) to[size_t(k)] = 0;
}

void SplineLines::solve() {
    const int count = int(values_.size());
    const auto sum = [&](int i, SlopeFilter filter, double scale) {
        Lanes& to = work_[size_t(i)] = {};
        for (const SlopeDifference& one : slope_differences(filter, i, count, wrap_))
            for (size_t k = 0; k < spline_lanes; ++k)
                to[k] += scale * one.weight * (values_[size_t(one.plus)][k] - values_[size_t(one.minus)][k]);
    };
    for (int i = 0; i < count; ++i) {
        const bool is_end = !wrap_ && (i == 0 || i == count - 1);
        sum(i, is_end ? SlopeFilter::spline : SlopeFilter::central, is_end ? 1 : 6);
    }
    if (wrap_)
        solve_around();
    else
        solve_between_ends();
}

/// Solves the cyclic system (1, 4, 1) by two recursions with the pole z = sqrt(3) - 2 (Unser 1999), with exact start
/// values.
void SplineLines::solve_around() {
    const int count = int(values_.size());
    const double z = std::sqrt(3.0) - 2, around = 1 / (1 - std::pow(z, count));
    const int memory = std::min(count, 40);  // z^40 is 1e-23, below double precision
    const auto at = [&](int i) { return size_t(inside(i, count, true)); };
    for (size_t k = 0; k < spline_lanes; ++k) {
        double first = 0;
        for (int i = memory; i-- > 0;) first = first * z + work_[at(-i)][k];
        work_[0][k] = first * around;
    }
    for (size_t i = 1; i < work_.size(); ++i)
        for (size_t k = 0; k < spline_lanes; ++k) work_[i][k] += z * work_[i - 1][k];
    for (size_t k = 0; k < spline_lanes; ++k) {
        double last = 0;
        for (int i = memory; i-- > 0;) last = last * z + work_[at(count - 1 + i)][k];
        values_.back()[k] = -z * last * around;
    }
    for (size_t i = work_.size() - 1; i-- > 0;)
        for (size_t k = 0; k < spline_lanes; ++k) values_[i][k] = z * (values_[i + 1][k] - work_[i][k]);
}

void SplineLines::solve_between_ends() {
    const size_t count = values_.size();
    values_.front() = work_.front(), values_.back() = work_.back();
    if (count < 3) return;
    // Rows 1 to count - 2; the ends are known.
    for (size_t i = 1; i + 1 < count; ++i)
        for (size_t k = 0; k < spline_lanes; ++k) {
            double& r = work_[i][k];
            if (i == 1) r -= values_.front()[k];
            if (i + 2 == count) r -= values_.back()[k];
            if (i > 1) r -= work_[i - 1][k];
            r *= factors_[i - 1];
        }
    for (size_t i = count - 2; i >= 1; --i)
        for (size_t k = 0; k < spline_lanes; ++k)
            values_[i][k] = work_[i][k] - (i + 2 < count ? factors_[i - 1] * values_[i + 1][k] : 0);
}

namespace {

/// Smooths along both axes by (1 4 6 4 1) / 16, with a spacing of `spacing` texels between taps.
Image smoothed(const Image& image, int spacing, bool wrap, unsigned threads) {
    constexpr std::array weights = {1 / 16.0, 4 / 16.0, 6 / 16.0, 4 / 16.0, 1 / 16.0};
    Image across(image.width, image.height, 1), result(image.width, image.height, 1);
    const auto rows = [&](const auto& row) {
        parallel_pieces(size_t(image.height), 8, threads, [&](size_t begin, size_t end) {
            for (size_t y = begin; y < end; ++y) row(int(y));
        });
    };
    const auto tap = [&](int i, int k, int count) { return inside(i + (k - 2) * spacing, count, wrap); };
    rows([&](int y) {
        for (int x = 0; x < image.width; ++x) {
            double sum = 0;
            for (int k = 0; k < 5; ++k) sum += weights[size_t(k)] * *image.pixel(tap(x, k, image.width), y);
            *across.pixel(x, y) = float(sum);
        }
    });
    rows([&](int y) {
        for (int x = 0; x < image.width; ++x) {
            double sum = 0;
            for (int k = 0; k < 5; ++k) sum += weights[size_t(k)] * *across.pixel(x, tap(y, k, image.height));
            *result.pixel(x, y) = float(sum);
        }
    });
    return result;
}

}  // namespace

Image slope_table(SlopeFilter filter, int count, bool wrap) {
    const bool is_spline = filter == SlopeFilter::spline;
    Image table(is_spline ? count : 4, count, 3);
    const auto set = [&](int column, int i, double plus, double minus, double weight) {
        float* const texel = table.pixel(column, count - 1 - i);
        texel[0] = float(plus), texel[1] = float(minus), texel[2] = float(weight);
    };
    if (!is_spline) {
        for (int i = 0; i < count; ++i)
            for (int column = 0; const auto& [plus, minus, weight] : slope_differences(filter, i, count, wrap))
                set(column++, i, plus, minus, weight);
        return table;
    }
    // Column k holds the slopes of an impulse: the line that is 1 at texel k and 0 elsewhere.
    std::vector<float> impulse(size_t(count), 0.0f);
    for (int k = 0; k < count; ++k) {
        impulse[size_t(k)] = 1;
        SplineLines lines(count, wrap);
        for (int i = 0; i < count; ++i) lines.set(i, &impulse[size_t(i)], 1, 1);
        lines.solve();
        for (int i = 0; i < count; ++i) set(k, i, k, i, lines.slope(i, 0));
        impulse[size_t(k)] = 0;
    }
    return table;
}

Image with_level_strengths(const Image& heights, const std::vector<double>& strengths, bool wrap, unsigned threads) {
    Image result = heights, finer = heights;
    // Levels wider than the map hold no more detail. Sides are at most 16384, so the shift cannot overflow.
    const int side = std::max(heights.width, heights.height);
    for (size_t level = 0; level < strengths.size() && (1 << level) <= side; ++level) {
        Image coarser = smoothed(finer, 1 << level, wrap, threads);
        const double more = strengths[level] - 1;
        for (size_t i = 0; i < result.values.size(); ++i)
            result.values[i] += float(more * (double(finer.values[i]) - coarser.values[i]));
        finer = std::move(coarser);
    }
    return result;
}

}  // namespace relief
