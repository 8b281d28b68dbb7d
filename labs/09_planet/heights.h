// The heights of lab 09's planet, in closed form: noise for continents and ridges, craters, a calm sea. The twin of
// shaders/09_planet/heights.glsl. `Number` is double or a type with the same operations, such as Dual in
// staff/dual.h, which carries the gradient along.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>

namespace relief::planet {

template <class Number>
using Place = std::array<Number, 3>;

/// The parameters of the heights.
struct Ground {
    int seed = 0;
    int detail = 4;    ///< octaves of ridges, 0 to 5
    float height = 1;  ///< factor on the relief; 0 is a smooth sphere
    bool operator==(const Ground&) const = default;
};

/// Returns the hash PCG3D of three integers (Jarzynski and Olano 2020).
inline glm::uvec3 scrambled(glm::uvec3 v) {
    v = v * 1664525u + 1013904223u;
    v.x += v.y * v.z, v.y += v.z * v.x, v.z += v.x * v.y;
    v ^= v >> 16u;
    v.x += v.y * v.z, v.y += v.z * v.x, v.z += v.x * v.y;
    return v;
}

inline double value_of(double x) { return x; }

/// Returns Perlin's noise with a fifth-degree blend (2002), whose gradient is continuous. About -1 to 1, mean 0.
template <class Number>
Number noise(const Place<Number>& p) {
    const std::array<double, 3> low = {std::floor(value_of(p[0])), std::floor(value_of(p[1])),
                                       std::floor(value_of(p[2]))};
    const Place<Number> f = {p[0] - low[0], p[1] - low[1], p[2] - low[2]};
    std::array<std::array<Number, 2>, 3> weight;
    for (size_t i = 0; i < 3; ++i) {
        const Number w = f[i] * f[i] * f[i] * (f[i] * (f[i] * 6.0 - 15.0) + 10.0);
        weight[i] = {1.0 - w, w};
    }
    Number sum = f[0] * 0.0;
    for (unsigned corner = 0; corner < 8; ++corner) {
        const unsigned x = corner & 1u, y = corner >> 1u & 1u, z = corner >> 2u;
        const glm::uvec3 bits = scrambled(glm::uvec3(uint32_t(int32_t(low[0])) + x, uint32_t(int32_t(low[1])) + y,
                                                     uint32_t(int32_t(low[2])) + z)) >>
                                16u;
        const glm::dvec3 slope = glm::dvec3(bits) / 32767.5 - 1.0;
        const Number rise = (f[0] - double(x)) * slope.x + (f[1] - double(y)) * slope.y + (f[2] - double(z)) * slope.z;
        sum = sum + weight[0][x] * weight[1][y] * weight[2][z] * rise;
    }
    return sum;
}

/// Returns a smooth maximum of x and 0, for a shore without a crease. Positive; close to x far above 0, and close to 0
/// far below. `softness` is the width of the transition.
template <class Number>
Number above_sea(const Number& x, double softness) {
    using std::sqrt;
    return (x + sqrt(x * x + softness * softness)) * 0.5;
}

struct Crater {
    glm::dvec3 middle;  ///< unit
    double size;        ///< 1 - cos of the rim's angle
};
inline constexpr int crater_count = 14;

inline Crater crater(int seed, int i) {
    const glm::uvec3 a = scrambled({uint32_t(i), uint32_t(seed), 77u}) >> 16u,
                     b = scrambled({uint32_t(i), uint32_t(seed), 78u}) >> 16u;
    const glm::dvec3 at = glm::dvec3(a) / 32767.5 - 1.0;
    const double x = double(b.x) / 65535;
    return {at / std::max(1e-3, glm::length(at)), 0.0016 + 0.014 * x * x * x};
}

using Craters = std::array<Crater, crater_count>;

/// Returns the craters of a seed. A thread computes them once for the heights of one seed in a row.
inline const Craters& craters_of(int seed) {
    const auto made = [](int of) {
        Craters craters;
        for (int i = 0; i < crater_count; ++i) craters[size_t(i)] = crater(of, i);
        return craters;
    };
    thread_local int known = seed;
    thread_local Craters craters = made(seed);
    if (known != seed) craters = made(seed), known = seed;
    return craters;
}

/// Returns the elevation of the ground at the unit vector r, in radii of the planet. Negative below the sea.
template <class Number>
Number elevation(const Ground& ground, const Place<Number>& r) {
    using std::exp, std::sqrt;
    const double shift = 19.7 * ground.seed;
    const auto at = [&](double scale, double x, double y, double z) {
        return Place<Number>{r[0] * scale + (x + shift), r[1] * scale + (y - shift), r[2] * scale + (z + 0.5 * shift)};
    };
    const Number land = noise(at(1.35, 3.1, 7.7, 1.3)) + noise(at(2.9, 11.3, 5.1, 8.9)) * 0.5 +
                        noise(at(6.1, 2.7, 17.9, 4.3)) * 0.22 + 0.06;
    // Mountains inland, in ranges.
    const Number inland = 1.0 / (exp((land - 0.16) * -16.0) + 1.0);
    Number ridges = r[0] * 0.0;
    double scale = 5.3, strength = 1;
    for (int octave = 0; octave < ground.detail; ++octave, scale *= 2.07, strength *= 0.47) {
        const Number n = noise(at(scale, 5.7 * octave + 1.9, 3.3, 9.1 * octave));
        ridges = ridges + (0.55 - sqrt(n * n * 5.0 + 0.034)) * strength;
    }
    Number sum = land * 0.05 + inland * (ridges + 0.35) * 0.045;
    for (const Crater& c : craters_of(ground.seed)) {
        // 0 in the middle, 1 on the rim.
        const Number d = (1.0 - (r[0] * c.middle.x + r[1] * c.middle.y + r[2] * c.middle.z)) * (1 / c.size);
        if (value_of(d) > 4) continue;  // contributes less than 1e-13
        const double deep = 0.14 * std::sqrt(c.size);
        sum = sum + (exp((d - 1.0) * (d - 1.0) * -5.0) * 0.6 - exp(d * d * -2.0) * 1.0) * deep;
    }
    return sum;
}

/// Returns the height of the ground or of the sea at the unit vector r. It is at least 0, in radii of the planet above
/// its sphere of radius 1.
template <class Number>
Number height(const Ground& ground, const Place<Number>& r) {
    return above_sea(elevation(ground, r), 0.002) * double(ground.height);
}
inline double height(const Ground& ground, const glm::dvec3& r) { return height(ground, Place<double>{r.x, r.y, r.z}); }

}  // namespace relief::planet
