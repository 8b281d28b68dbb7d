#include "framework/library/maps/test_maps.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <random>
#include <utility>

#include "framework/core/base/parallel.h"

namespace relief {
namespace {

/// Fills an image with `value` of each texel's column and row.
Image by_texel(int size, const std::function<float(int x, int y)>& value) {
    Image image(size, size, 1);
    parallel_pieces(size_t(size), 16, 0, [&](size_t begin, size_t end) {
        for (int y = int(begin); y < int(end); ++y)
            for (int x = 0; x < size; ++x) *image.pixel(x, y) = value(x, y);
    });
    return image;
}

void stretch_to_unit(Image& image) {
    const auto [low, high] = std::minmax_element(image.values.begin(), image.values.end());
    const float lowest = *low, scale = *high > lowest ? 1 / (*high - lowest) : 0;
    for (float& value : image.values) value = (value - lowest) * scale;
}

struct Wave {
    int kx, ky;  ///< periods in the tile
    double phase, amplitude;
};

/// Returns waves of `shortest` to `longest` periods per tile, evenly distributed over octaves, with amplitudes of
/// frequency^-fall. The set of all waves has four times as many in each octave as in the one below. So these few
/// represent all waves with amplitudes of frequency^-(fall + 1).
std::vector<Wave> random_waves(int count, double shortest, double longest, double fall, uint32_t seed) {
    std::mt19937 random(seed);
    const auto share = [&] { return double(random()) / 4294967296.0; };
    std::vector<Wave> waves;
    for (int i = 0; i < count; ++i) {
        const double k = shortest * std::pow(longest / shortest, share()), turn = 2 * std::numbers::pi * share();
        const int kx = int(std::lround(k * std::cos(turn))), ky = int(std::lround(k * std::sin(turn)));
        waves.push_back({kx, ky, 2 * std::numbers::pi * share(), std::pow(std::max(1.0, std::hypot(kx, ky)), -fall)});
    }
    return waves;
}

/// Uses cos(a + b) = cos a cos b - sin a sin b: two multiplications per texel and wave, and no cosine.
Image sum_of(const std::vector<Wave>& waves, int size) {
    std::vector<float> along_x(waves.size() * 2 * size_t(size));
    parallel_pieces(waves.size(), 8, 0, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i)
            for (int x = 0; x < size; ++x) {
                const double angle = 2 * std::numbers::pi * (int64_t(waves[i].kx) * x % size) / size;
                along_x[i * 2 * size_t(size) + size_t(x)] = float(std::cos(angle));
                along_x[(i * 2 + 1) * size_t(size) + size_t(x)] = float(std::sin(angle));
            }
    });
    Image image(size, size, 1);
    parallel_pieces(size_t(size), 1, 0, [&](size_t begin, size_t end) {
        for (int y = int(begin); y < int(end); ++y) {
            float* const row = image.pixel(0, y);
            for (size_t i = 0; i < waves.size(); ++i) {
                const double angle = 2 * std::numbers::pi * (int64_t(waves[i].ky) * y % size) / size + waves[i].phase;
                const float c = float(waves[i].amplitude * std::cos(angle)),
                            s = float(waves[i].amplitude * std::sin(angle));
                const float *const cosines = &along_x[i * 2 * size_t(size)], *const sines = cosines + size;
                for (int x = 0; x < size; ++x) row[x] += c * cosines[x] - s * sines[x];
            }
        }
    });
    stretch_to_unit(image);
    return image;
}

/// Hashes two numbers to [0, 1) by lowbias32 (Wellons 2018).
float dice(uint32_t a, uint32_t b) {
    uint32_t x = a * 0x9e3779b9u + b;
    x = (x ^ (x >> 16)) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    return float((x ^ (x >> 16)) >> 8) * 0x1p-24f;
}

float smooth_step(float low, float high, float x) {
    const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
}

Image bricks(int size) {
    const Image joints = sum_of(random_waves(60, 4, 32, 1, 11), size);
    const float courses = 8, length = float(size) / 4, height = float(size) / courses, gap = float(size) / 128;
    Image image = by_texel(size, [&](int x, int y) {
        const int course = int(float(y) / height);
        const float along = std::fmod(float(x) + (course % 2 ? length / 2 : 0), length);
        const float across = float(y) - float(course) * height;
        const float inside = std::min({along, length - along, across, height - across}) - gap;
        const float joint = 0.15f * *joints.pixel(x, y);
        return joint + (1 - joint) * std::clamp(inside / 2, 0.0f, 1.0f);
    });
    stretch_to_unit(image);
    return image;
}

/// Worley noise (1996) with one random point per cell. Joints are where the two nearest points are equally far.
Image stones(int size) {
    constexpr int cells = 8, reach = 2, width = 2 * reach + 1, count = width * width;
    struct Stone {
        float x, y, top;  ///< its point's place in its cell, and its height
    };
    std::array<Stone, cells * cells> all{};
    for (uint32_t id = 0; id < all.size(); ++id)
        all[id] = {0.7f * dice(id, 1), 0.7f * dice(id, 2), 0.65f + 0.35f * dice(id, 3)};
    struct Neighbours {
        std::array<float, count> x, y, top;
    };
    std::vector<Neighbours> of_cell(all.size());  // the same stones are near all texels of a cell
    for (int cell = 0; cell < cells * cells; ++cell)
        for (int n = 0; n < count; ++n) {
            const int i = cell % cells - reach + n % width, j = cell / cells - reach + n / width;
            const Stone& stone = all[size_t((j + cells) % cells * cells + (i + cells) % cells)];
            of_cell[size_t(cell)].x[size_t(n)] = float(i) + 0.15f + stone.x;
            of_cell[size_t(cell)].y[size_t(n)] = float(j) + 0.15f + stone.y;
            of_cell[size_t(cell)].top[size_t(n)] = stone.top;
        }
    Image image = by_texel(size, [&](int x, int y) {
        const float px = float(x) * cells / float(size), py = float(y) * cells / float(size);
        const Neighbours& near = of_cell[size_t(int(py) * cells + int(px))];
        std::array<float, count> squares{};
        for (size_t n = 0; n < count; ++n) {
            const float dx = near.x[n] - px, dy = near.y[n] - py;
            squares[n] = dx * dx + dy * dy;
        }
        float first = 81, second = 81, top = 0;
        for (size_t n = 0; n < count; ++n)
            if (squares[n] < first) {
                second = std::exchange(first, squares[n]);
                top = near.top[n];
            } else {
                second = std::min(second, squares[n]);
            }
        const float nearest = std::sqrt(first), dome = 1 - 0.45f * nearest * nearest;
        return top * dome * smooth_step(0.02f, 0.28f, std::sqrt(second) - nearest);
    });
    stretch_to_unit(image);
    return image;
}

Image posts(int size) {
    Image image = by_texel(size, [&](int x, int y) {
        const bool post = x % 16 == std::min(8, size - 1) && y % 16 == std::min(8, size - 1);
        return post ? 0.5f + 0.5f * dice(uint32_t(x), uint32_t(y)) : 0.0f;
    });
    stretch_to_unit(image);
    return image;
}

Image rock(int size) {
    const Image mass = sum_of(random_waves(120, 1, 24, 1.2, 21), size);
    const Image detail = sum_of(random_waves(240, 8, float(size) / 5, 1.1, 22), size);
    const Image cracks = sum_of(random_waves(80, 2, 20, 1, 23), size);
    Image image = by_texel(size, [&](int x, int y) {
        // Ledges: flat steps with steep rises between them.
        const float rise = *mass.pixel(x, y) * 6, step = std::floor(rise);
        const float ledges = (step + smooth_step(0.35f, 0.65f, rise - step)) / 6;
        const float crack = smooth_step(0.0f, 0.03f, std::abs(*cracks.pixel(x, y) - 0.5f));
        const float grain = dice(uint32_t(x), uint32_t(y) + 77u);
        return (0.55f * ledges + 0.35f * *detail.pixel(x, y) + 0.02f * grain) * (0.6f + 0.4f * crack);
    });
    stretch_to_unit(image);
    return image;
}

Image flat(int size, float height) {
    Image image(size, size, 1);
    std::fill(image.values.begin(), image.values.end(), height);
    return image;
}

Image damaged(int size) {
    Image image = stones(size);
    const float bad[] = {NAN, INFINITY, -INFINITY, 1e30f, -3};
    for (size_t i = 0; i < std::size(bad); ++i) image.values[image.values.size() * (i * 2 + 1) / 11] = bad[i];
    return image;
}

}  // namespace

Image make_height_map(HeightMap map, int size) {
    switch (map) {
        case HeightMap::smooth:
            return sum_of(random_waves(60, 1, 8, 1, 1), size);
        case HeightMap::fbm:
            return sum_of(random_waves(256, 1, std::max(1.0, size / 4.0), 1, 2), size);
        case HeightMap::bricks:
            return bricks(size);
        case HeightMap::stones:
            return stones(size);
        case HeightMap::posts:
            return posts(size);
        case HeightMap::rock:
            return rock(size);
        case HeightMap::low:
            return flat(size, 0);
        case HeightMap::high:
            return flat(size, 1);
        case HeightMap::plateau:
            return flat(size, 0.5f);
        case HeightMap::damaged:
            return damaged(size);
    }
    return {};
}

void mend_heights(Image& heights) {
    for (float& height : heights.values) height = height > 0 ? std::min(height, 1.0f) : 0.0f;  // NaN > 0 is false
}

Image with_8_bits(Image heights) {
    for (float& height : heights.values) height = std::round(height * 255) / 255;
    heights.bits = 8;
    return heights;
}

}  // namespace relief
