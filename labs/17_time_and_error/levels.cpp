#include "levels.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "framework/core/base/parallel.h"
#include "framework/core/image/mips.h"

namespace relief {
namespace {

/// Linear interpolation at `place` on a line of `count` samples that repeats; sample i is at i.
struct Between {
    int first, second;
    float share;  ///< weight of `second`
    Between(double place, int count) {
        const double before = std::floor(place);
        first = (int(before) % count + count) % count, second = (first + 1) % count;
        share = float(place - before);
    }
    float of(const float* line) const { return line[first] + share * (line[second] - line[first]); }
};

/// Interpolates linearly between two rows of an image, at `place` texels from its top border. Writes one value per
/// column. Row 0 lies `offset` texels from the border.
void row_at(const Image& image, double place, double offset, std::vector<float>& row) {
    const Between rows(place - offset, image.height);
    row.resize(size_t(image.width));
    const float *a = image.pixel(0, rows.first), *b = image.pixel(0, rows.second);
    for (int x = 0; x < image.width; ++x) row[size_t(x)] = a[x] + rows.share * (b[x] - a[x]);
}

/// Returns the maximum difference of two bilinear surfaces. Both are bilinear within squares of half a texel of `fine`,
/// so the maximum is at a corner of such a square. The outermost samples of `coarse` lie `offset` of its own texels
/// from its border.
float most_apart(const Image& fine, const Image& coarse, double offset) {
    float largest = 0;
    std::mutex mutex;
    const double u = double(coarse.width) / fine.width / 2, v = double(coarse.height) / fine.height / 2;
    std::vector<Between> in_fine, in_coarse;
    for (int x = 0; x < fine.width * 2; ++x)
        in_fine.emplace_back(x / 2.0 - 0.5, fine.width), in_coarse.emplace_back(x * u - offset, coarse.width);
    parallel_pieces(size_t(fine.height) * 2, 32, 0, [&](size_t begin, size_t end) {
        float here = 0;
        std::vector<float> a, b;
        for (size_t y = begin; y < end; ++y) {
            row_at(fine, double(y) / 2, 0.5, a), row_at(coarse, double(y) * v, offset, b);
            for (size_t x = 0; x < in_fine.size(); ++x)
                here = std::max(here, std::abs(in_fine[x].of(a.data()) - in_coarse[x].of(b.data())));
        }
        const std::scoped_lock lock(mutex);
        largest = std::max(largest, here);
    });
    return largest;
}

/// Maximum curvature of an image's bilinear surface. `twist` is over the squares between samples. `kink` is the change
/// of slope at a sample, along both axes together.
struct Bend {
    float twist = 0, kink = 0;
};
Bend most_bent(const Image& image) {
    Bend largest;
    const auto at = [&](int x, int y) {
        return *image.pixel((x + image.width) % image.width, (y + image.height) % image.height);
    };
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const float here = at(x, y), right = at(x + 1, y), below = at(x, y + 1);
            largest.twist = std::max(largest.twist, std::abs(here - right - below + at(x + 1, y + 1)));
            largest.kink =
                std::max(largest.kink, std::hypot(at(x - 1, y) - 2 * here + right, at(x, y - 1) - 2 * here + below));
        }
    return largest;
}

/// Appends an error, raised to the last one if it is smaller. Returns false, and appends nothing, when the error is not
/// below `enough`. The first error is always appended.
bool add(std::vector<float>& errors, float error, float enough) {
    if (!errors.empty()) error = std::max(error, errors.back());
    if (!errors.empty() && error >= enough) return false;
    errors.push_back(error);
    return true;
}

}  // namespace

std::vector<float> level_errors(const Image& heights, float enough) {
    const std::vector<Image> levels = mip_chain(heights, ColorSpace::linear);
    std::vector<float> errors;
    for (const Image& level : levels) {
        // A step of one texel, (a, b) with a² + b² = 1, crosses at most one grid line along each axis. A change of
        // slope by J deviates from the chord by at most J / 4, where it is in the middle of the step. A square's twist
        // T deviates by at most 2 T a b / 8.
        const Bend bend = most_bent(level);
        const float apart = errors.empty() ? 0 : most_apart(levels[0], level, 0.5);
        if (!add(errors, apart + bend.kink / 4 + bend.twist / 8, enough)) break;
    }
    return errors;
}

std::vector<float> piece_errors(const Image& heights, float enough) {
    std::vector<float> errors;
    for (int side = 1; side <= std::min(heights.width, heights.height); side *= 2) {
        Image corners(heights.width / side, heights.height / side, 1);
        std::vector<float> row;
        for (int y = 0; y < corners.height; ++y) {
            row_at(heights, double(y) * side, 0.5, row);
            for (int x = 0; x < corners.width; ++x)
                *corners.pixel(x, y) = Between(double(x) * side - 0.5, heights.width).of(row.data());
        }
        if (!add(errors, most_apart(heights, corners, 0) + most_bent(corners).twist / 4, enough)) break;
    }
    return errors;
}

}  // namespace relief
