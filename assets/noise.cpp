#include "assets/noise.h"

#include <array>
#include <limits>

namespace relief {
namespace {

// Rounds down to an integer. std::floor is a function call on baseline x86-64.
int floor_of(float x) {
    const int toward_zero = static_cast<int>(x);
    return toward_zero - (x < static_cast<float>(toward_zero));
}

// The position within its cell along one axis, and the wrapped indices of that cell and its neighbours. Noise takes
// most of the generator's time, so it avoids integer division.
struct Axis {
    float inside;
    uint32_t before, here, after;

    Axis(float p, uint32_t cells) {
        const float x = (p - static_cast<float>(floor_of(p))) * static_cast<float>(cells);
        here = static_cast<uint32_t>(x);
        inside = x - static_cast<float>(here);
        if (here >= cells) here = 0;  // p just below an integer may round up
        before = (here == 0 ? cells : here) - 1;
        after = here + 1 == cells ? 0 : here + 1;
    }
};

// Returns hash bits of a lattice point. The two odd factors separate all points of lattices with fewer than 65536
// cells.
uint32_t point_bits(uint32_t start, uint32_t x, uint32_t y) { return hash(start + x * 0x9e3779b1u + y * 0x85ebca77u); }

// Converts each 16 bits to [-1, 1].
constexpr glm::vec2 signed_pair(uint32_t bits) {
    return {static_cast<float>(bits & 0xffff) * (2.0f / 65535) - 1,
            static_cast<float>(bits >> 16) * (2.0f / 65535) - 1};
}

// A table: computing a gradient at each corner would take longer than the rest.
constexpr std::array<glm::vec2, 256> gradients = [] {
    std::array<glm::vec2, 256> table{};
    for (uint32_t i = 0; i < 256; ++i) table[i] = 1.6f * signed_pair(hash(i, 1));
    return table;
}();

}  // namespace

float gradient_noise(glm::vec2 p, glm::ivec2 cells, uint32_t seed) {
    const Axis u(p.x, cells.x), v(p.y, cells.y);
    const uint32_t start = hash(seed);
    const auto ease = [](float t) { return t * t * t * (t * (t * 6 - 15) + 10); };
    const auto row = [&](uint32_t number, float y) {
        const glm::vec2& left = gradients[point_bits(start, u.here, number) >> 24];
        const glm::vec2& right = gradients[point_bits(start, u.after, number) >> 24];
        return glm::mix(left.x * u.inside + left.y * y, right.x * (u.inside - 1) + right.y * y, ease(u.inside));
    };
    return glm::mix(row(v.here, v.inside), row(v.after, v.inside - 1), ease(v.inside));
}

float turned_noise(glm::vec2 p, int cells, uint32_t seed) {
    // This rotation has integer coefficients, so it maps tiles to whole tiles. It also scales by the square root of 5.
    const int fitting = glm::max(1, static_cast<int>(cells / 2.2360680f + 0.5f));
    return gradient_noise({2 * p.x + p.y, 2 * p.y - p.x}, glm::ivec2(fitting), seed);
}

float fractal_noise(glm::vec2 p, int cells, int octaves, uint32_t seed) {
    float sum = 0, size = 1, power = 0;
    for (int i = 0; i < octaves; ++i, size /= 2, cells *= 2) {
        // Alternate both lattices: aligned lattice lines of several octaves would form a visible weave.
        sum += size * (i % 2 ? turned_noise(p, cells, seed + i) : gradient_noise(p, glm::ivec2(cells), seed + i));
        power += size * size;
    }
    return sum / glm::sqrt(power);
}

float grain_noise(glm::vec2 p, uint32_t seed) {
    // Two lattices at different angles: a single one would be visible.
    return 0.7f * (turned_noise(p / tile, 293, seed) + turned_noise(glm::vec2(p.y, p.x) / tile, 181, seed + 1));
}

NearestPoint cellular_noise(glm::vec2 p, glm::ivec2 cells, uint32_t seed) {
    const Axis u(p.x, cells.x), v(p.y, cells.y);
    const uint32_t start = hash(seed);
    float nearest = std::numeric_limits<float>::max();
    uint32_t id = 0;
    const uint32_t columns[] = {u.before, u.here, u.after}, rows[] = {v.before, v.here, v.after};
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 3; ++x) {
            const uint32_t bits = point_bits(start, columns[x], rows[y]);
            const glm::vec2 point = glm::vec2(x - 0.5f, y - 0.5f) + 0.5f * signed_pair(bits);
            const float square =
                (point.x - u.inside) * (point.x - u.inside) + (point.y - v.inside) * (point.y - v.inside);
            if (square < nearest) nearest = square, id = bits;
        }
    return {glm::sqrt(nearest), hash(id)};
}

}  // namespace relief
