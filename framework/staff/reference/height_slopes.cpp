#include "framework/staff/reference/height_slopes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace relief {
namespace {

using Line = std::function<double(int)>;  // heights of a line; accepts any index if the line wraps

/// Difference by polynomials through the nearest `order + 1` elements at the border, and by the centred formula inside.
double difference(const Line& h, int i, int count, int order, bool wrap) {
    const bool second = order == 2;
    if (wrap || (second ? i >= 1 && i < count - 1 : i >= 2 && i < count - 2))
        return second ? (h(i + 1) - h(i - 1)) / 2 : (8 * (h(i + 1) - h(i - 1)) - (h(i + 2) - h(i - 2))) / 12;
    if (count == 1) return 0;
    if (count == 2) return h(1) - h(0);
    if (!second && count < 5) return difference(h, i, count, 2, wrap);
    // The derivative at i of the Lagrange polynomial through order + 1 elements, with as few as possible beyond i.
    const int first = i < count / 2 ? 0 : count - 1 - order;
    double sum = 0;
    for (int j = first; j <= first + order; ++j) {
        double slope = 0;
        for (int m = first; m <= first + order; ++m) {
            if (m == j) continue;
            double product = 1.0 / (j - m);
            for (int k = first; k <= first + order; ++k)
                if (k != j && k != m) product *= double(i - k) / (j - k);
            slope += product;
        }
        sum += slope * h(j);
    }
    return sum;
}

/// On a circle the inverse of (1, 4, 1) is the kernel z^|k| / (2 sqrt(3)), z = sqrt(3) - 2. Between ends the equations
/// are relaxed until nothing changes: each sweep leaves a quarter of the error.
double spline(const Line& h, int i, int count, bool wrap) {
    if (wrap) {
        const double z = std::sqrt(3.0) - 2;
        double sum = 0;
        for (int k = -40; k <= 40; ++k)
            sum += std::pow(z, std::abs(k)) / (2 * std::sqrt(3.0)) * 3 * (h(i + k + 1) - h(i + k - 1));
        return sum;
    }
    std::vector<double> m(size_t(count), 0.0);
    m.front() = difference(h, 0, count, 4, false), m.back() = difference(h, count - 1, count, 4, false);
    for (int sweep = 0; sweep < 60; ++sweep)
        for (int k = 1; k < count - 1; ++k)
            m[size_t(k)] = (3 * (h(k + 1) - h(k - 1)) - m[size_t(k) - 1] - m[size_t(k) + 1]) / 4;
    return m[size_t(i)];
}

double slope(const Line& h, int i, int count, SlopeFilter filter, bool wrap) {
    switch (filter) {
        case SlopeFilter::forward:
            if (!wrap && count == 1) return 0;
            return wrap || i + 1 < count ? h(i + 1) - h(i) : h(i) - h(i - 1);
        case SlopeFilter::fourth_order:
            return difference(h, i, count, 4, wrap);
        case SlopeFilter::spline:
            return spline(h, i, count, wrap);
        default:
            return difference(h, i, count, 2, wrap);
    }
}

double beside(SlopeFilter filter) {
    return filter == SlopeFilter::sobel ? 0.25 : filter == SlopeFilter::scharr ? 3 / 16.0 : 0;
}

}  // namespace

glm::dvec2 slope_at(const Image& heights, int x, int y, SlopeFilter filter, bool wrap) {
    const int width = heights.width, height = heights.height;
    const auto height_at = [&](int column, int row) -> double {
        const auto around = [](int i, int n) { return ((i % n) + n) % n; };
        if (wrap) return *heights.pixel(around(column, width), around(row, height));
        return *heights.pixel(std::clamp(column, 0, width - 1), std::clamp(row, 0, height - 1));
    };
    glm::dvec2 sum(0);
    for (int k = -1; k <= 1; ++k) {
        const double weight = k == 0 ? 1 - 2 * beside(filter) : beside(filter);
        if (weight == 0) continue;
        sum.x += weight * slope([&](int i) { return height_at(i, y + k); }, x, width, filter, wrap);
        // Upwards: row 0 is the top.
        const Line column = [&](int i) { return height_at(x + k, height - 1 - i); };
        sum.y += weight * slope(column, height - 1 - y, height, filter, wrap);
    }
    return sum;
}

glm::dvec3 normal_at(const Image& heights, int x, int y, const NormalOptions& options) {
    const glm::dvec2 slopes =
        slope_at(heights, x, y, options.filter, options.wrap) * glm::dvec2(options.texels_u, options.texels_v);
    return glm::normalize(glm::dvec3(-slopes, 1));
}

}  // namespace relief
