#include "framework/course/inspect/slopes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace relief::inspect {
namespace {

constexpr size_t fewest_texels = 36;

bool is_none(glm::vec2 slope) { return std::isnan(slope.x); }

/// Sums over texels. a and b are the two mixed derivatives, equal in a height field; c and d are the other two.
struct Sums {
    size_t count = 0;
    double ab = 0, squares_ab = 0, cd = 0, squares_cd = 0;

    void add(const Slopes& slopes, int x, int y) {
        const glm::vec2 left = slopes.at(x - 1, y), right = slopes.at(x + 1, y), above = slopes.at(x, y - 1),
                        below = slopes.at(x, y + 1);
        if (is_none(left) || is_none(right) || is_none(above) || is_none(below)) return;
        const glm::dvec2 along_u = (glm::dvec2(right) - glm::dvec2(left)) / 2.0,
                         along_v = (glm::dvec2(above) - glm::dvec2(below)) / 2.0;
        const double a = along_v.x, b = along_u.y, c = along_v.y, d = along_u.x;
        // Keeps a few steep texels from outweighing all others.
        const double weight = 1 / (1 + glm::dot(along_u, along_u) + glm::dot(along_v, along_v));
        ab += weight * a * b, squares_ab += weight * (a * a + b * b);
        cd += weight * c * d, squares_cd += weight * (c * c + d * d);
        ++count;
    }
    double up() const { return squares_ab > 0 ? 2 * ab / squares_ab : 0; }
    double turned() const { return squares_cd > 0 ? 2 * cd / squares_cd : 0; }
};

Sums sums_of(const Slopes& slopes, int left, int top, int right, int bottom) {
    Sums sums;
    for (int y = std::max(top, 1); y < std::min(bottom, slopes.height - 1); ++y)
        for (int x = std::max(left, 1); x < std::min(right, slopes.width - 1); ++x) sums.add(slopes, x, y);
    return sums;
}

/// Returns the rms slopes along the two principal directions, the larger one first.
glm::dvec2 principal(const Slopes& slopes) {
    double xx = 0, xy = 0, yy = 0, count = 0;
    for (const glm::vec2 s : slopes.of) {
        if (is_none(s)) continue;
        xx += double(s.x) * s.x, xy += double(s.x) * s.y, yy += double(s.y) * s.y, ++count;
    }
    if (count == 0) return {0, 0};
    const double mean = (xx + yy) / 2, apart = std::hypot((xx - yy) / 2, xy);
    return {std::sqrt((mean + apart) / count), std::sqrt(std::max(0.0, mean - apart) / count)};
}

std::vector<float> one_channel(const Image& heights, int first, int channels) {
    std::vector<float> result(heights.pixel_count());
    for (size_t i = 0; i < result.size(); ++i) {
        double sum = 0;
        for (int c = first; c < first + channels; ++c) sum += heights.values[i * size_t(heights.channels) + size_t(c)];
        const double mean = sum / channels;
        result[i] = std::isfinite(mean) ? float(std::clamp(mean, -1e6, 1e6)) : NAN;
    }
    return result;
}

/// Weighted products of the two fields' components. Steep texels get small weights because their slopes are
/// inexact.
struct Products {
    double xx = 0, xy = 0, yx = 0, yy = 0, normals = 0, heights = 0;

    Products(const Slopes& n, const Slopes& h) {
        for (size_t i = 0; i < n.of.size(); ++i) {
            if (is_none(n.of[i]) || is_none(h.of[i])) continue;
            const glm::dvec2 s = n.of[i], t = h.of[i];
            const double bend = 1 + glm::dot(s, s), weight = 1 / (bend * bend);
            xx += weight * s.x * t.x, xy += weight * s.x * t.y, yx += weight * s.y * t.x, yy += weight * s.y * t.y;
            normals += weight * glm::dot(s, s), heights += weight * glm::dot(t, t);
        }
    }
    Agreement best() const {
        Agreement result;
        result.comparable = normals > 0 && heights > 0;
        if (!result.comparable) return result;
        for (int i = 0; i < 8; ++i) {
            const Channels channels{.swapped = (i & 4) != 0, .red_turned = (i & 2) != 0, .green_turned = (i & 1) != 0};
            const double product = (channels.red_turned ? -1 : 1) * (channels.swapped ? xy : xx) +
                                   (channels.green_turned ? -1 : 1) * (channels.swapped ? yx : yy);
            const double correlation = product / std::sqrt(normals * heights);
            if (correlation > result.correlation + 1e-9) {
                result.correlation = correlation;
                result.channels = channels;
                result.strength = product / heights;
            }
        }
        return result;
    }
};

/// Returns the best agreement over three resolutions of the slopes: rounding to 8 bits hides small, shallow detail.
Agreement best_agreement(Slopes normals, const Image& heights, int first, int channels) {
    Slopes theirs = slopes_of_heights(heights, first, channels);
    double texels = 1;
    for (; theirs.width > normals.width && theirs.width > 1; texels /= 2) theirs = halved(theirs);
    for (; normals.width > theirs.width && normals.width > 1; texels *= 2) normals = halved(normals);
    Agreement best;
    if (normals.width != theirs.width || normals.height != theirs.height) return best;
    for (int level = 0; level < 3 && normals.of.size() >= fewest_texels; ++level) {
        const Agreement found = Products(normals, theirs).best();
        if (!best.comparable || found.correlation > best.correlation + 0.02) best = found;
        normals = halved(normals), theirs = halved(theirs);
    }
    best.strength *= texels;
    return best;
}

}  // namespace

Slopes slopes_of_normals(std::span<const glm::vec3> normals, int width, int height) {
    Slopes slopes{width, height, std::vector<glm::vec2>(normals.size(), glm::vec2(NAN))};
    const float steepest = float(std::cos(85 * std::numbers::pi / 180));
    for (size_t i = 0; i < normals.size(); ++i) {
        const glm::vec3 n = normals[i];
        if (n.z > steepest * glm::length(n)) slopes.of[i] = glm::vec2(-n.x, -n.y) / n.z;
    }
    return slopes;
}

Slopes slopes_of_heights(const Image& heights, int first_channel, int channels) {
    const std::vector<float> h = one_channel(heights, first_channel, channels);
    const int width = heights.width, height = heights.height;
    Slopes slopes{width, height, std::vector<glm::vec2>(h.size(), glm::vec2(NAN))};
    for (int y = 1; y + 1 < height; ++y)
        for (int x = 1; x + 1 < width; ++x) {
            const size_t i = size_t(y) * size_t(width) + size_t(x), row = size_t(width);
            const glm::vec2 s((h[i + 1] - h[i - 1]) / 2, (h[i - row] - h[i + row]) / 2);
            if (!std::isnan(s.x + s.y)) slopes.of[i] = s;
        }
    return slopes;
}

Slopes halved(const Slopes& slopes) {
    Slopes half{slopes.width / 2, slopes.height / 2, {}};
    half.of.resize(size_t(half.width) * size_t(half.height));
    for (int y = 0; y < half.height; ++y)
        for (int x = 0; x < half.width; ++x)
            half.of[size_t(y) * size_t(half.width) + size_t(x)] =
                (slopes.at(2 * x, 2 * y) + slopes.at(2 * x + 1, 2 * y) + slopes.at(2 * x, 2 * y + 1) +
                 slopes.at(2 * x + 1, 2 * y + 1)) /
                4.0f;
    return half;
}

FieldTest test_field(const Slopes& slopes) {
    FieldTest best;
    const glm::dvec2 rms = principal(slopes);
    Slopes level = slopes;
    for (int i = 0; i < 3 && level.width >= 3 && level.height >= 3; ++i, level = halved(level)) {
        const Sums sums = sums_of(level, 0, 0, level.width, level.height);
        const double strongest = std::max(std::abs(sums.up()), std::abs(sums.turned()));
        if (sums.count < fewest_texels ||
            (best.count > 0 && strongest < std::max(std::abs(best.up), std::abs(best.turned)) + 0.05))
            continue;
        best = {.count = sums.count, .up = sums.up(), .turned = sums.turned()};
    }
    best.rms = std::hypot(rms.x, rms.y);
    best.across = rms.x > 0 ? rms.y / rms.x : 0;
    return best;
}

SquareTests test_squares(const Slopes& slopes, double noise) {
    SquareTests tests{};
    tests.side = std::max(32, std::max(slopes.width, slopes.height) / 64 / 4 * 4);
    tests.columns = (slopes.width + tests.side - 1) / tests.side;
    tests.rows = (slopes.height + tests.side - 1) / tests.side;
    tests.up.resize(size_t(tests.columns) * size_t(tests.rows));
    // Halving the slopes reveals shallow detail: the noise halves, and the change from texel to texel doubles.
    Slopes level = slopes;
    for (int side = tests.side; side >= tests.side / 4; side /= 2, noise /= 2, level = halved(level))
        for (size_t i = 0; i < tests.up.size(); ++i) {
            if (tests.up[i] != 0) continue;
            const int left = int(i) % tests.columns * side, top = int(i) / tests.columns * side;
            const Sums sums = sums_of(level, left, top, left + side, top + side);
            // A central difference has half of the slopes' squared noise, and squares_ab sums two of them.
            if (sums.count >= size_t(side * side / 2) && sums.squares_ab > 25 * double(sums.count) * noise * noise)
                tests.up[i] = sums.up();
        }
    return tests;
}

glm::dvec2 Channels::from(glm::dvec2 s) const {
    if (swapped) s = {s.y, s.x};
    return {red_turned ? -s.x : s.x, green_turned ? -s.y : s.y};
}

Agreement agreement(const Slopes& normals, const Image& heights, int first_channel, int channels) {
    Agreement best = best_agreement(normals, heights, first_channel, channels);
    if (!best.comparable || best.correlation > 0.6) return best;
    for (int i = 1; i < 8; ++i) {
        const Layout layout{(i & 1) != 0, (i & 2) != 0, (i & 4) != 0};
        if (layout.transposed && heights.width != heights.height) continue;
        Agreement found = best_agreement(normals, laid(heights, layout), first_channel, channels);
        found.layout = layout;
        if (found.correlation > std::max(0.6, best.correlation + 0.2)) best = found;
    }
    return best;
}

Image laid(const Image& picture, Layout layout) {
    Image result(layout.transposed ? picture.height : picture.width, layout.transposed ? picture.width : picture.height,
                 picture.channels, picture.bits);
    for (int y = 0; y < result.height; ++y)
        for (int x = 0; x < result.width; ++x) {
            int from_x = layout.transposed ? y : x, from_y = layout.transposed ? x : y;
            if (layout.mirrored_u) from_x = picture.width - 1 - from_x;
            if (layout.mirrored_v) from_y = picture.height - 1 - from_y;
            std::copy_n(picture.pixel(from_x, from_y), picture.channels, result.pixel(x, y));
        }
    return result;
}

}  // namespace relief::inspect
