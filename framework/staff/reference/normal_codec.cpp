#include "framework/staff/reference/normal_codec.h"

#include <algorithm>
#include <cmath>

#include "framework/staff/reference/half.h"

namespace relief {
namespace {

constexpr std::array<NormalFormatInfo, 13> formats = {{
    {NormalFormat::unorm8, "unorm8", 3, 8},
    {NormalFormat::unorm8_truncated, "unorm8-truncated", 3, 8},
    {NormalFormat::snorm8, "snorm8", 3, 8},
    {NormalFormat::paired8, "paired8", 3, 8},
    {NormalFormat::rg8, "rg8", 2, 8},
    {NormalFormat::rg16, "rg16", 2, 16},
    {NormalFormat::oct8, "oct8", 2, 8},
    {NormalFormat::oct8_precise, "oct8-precise", 2, 8},
    {NormalFormat::oct12, "oct12", 2, 12},
    {NormalFormat::oct12_precise, "oct12-precise", 2, 12},
    {NormalFormat::oct16, "oct16", 2, 16},
    {NormalFormat::oct16_precise, "oct16-precise", 2, 16},
    {NormalFormat::half, "half", 3, 16},
}};

/// Scales by the largest component first, because the squares of 1e200 or 1e-200 overflow or underflow.
glm::dvec3 unit_or_up(glm::dvec3 v) {
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z) || largest == 0) return {0, 0, 1};
    int exponent;
    std::frexp(largest, &exponent);
    v = {std::ldexp(v.x, -exponent), std::ldexp(v.y, -exponent), std::ldexp(v.z, -exponent)};
    return v / std::sqrt(glm::dot(v, v));
}

uint16_t unorm(double x, int bits) { return uint16_t(std::lround((0.5 * x + 0.5) * ((1 << bits) - 1))); }
double from_unorm(uint16_t c, int bits) { return 2.0 * c / ((1 << bits) - 1) - 1; }

int largest_snorm(int bits) { return (1 << (bits - 1)) - 1; }
uint16_t as_stored(int value, int bits) { return uint16_t(value & ((1 << bits) - 1)); }
double from_snorm(uint16_t c, int bits) {
    const int value = c >= 1 << (bits - 1) ? int(c) - (1 << bits) : c;
    return std::max(double(value) / largest_snorm(bits), -1.0);
}

double sign_not_zero(double x) { return x < 0 ? -1 : 1; }

/// Projects onto the octahedron |x| + |y| + |z| = 1, its lower half folded outwards over the square's corners.
glm::dvec2 onto_octahedron(glm::dvec3 n) {
    const glm::dvec2 p = glm::dvec2(n) / (std::abs(n.x) + std::abs(n.y) + std::abs(n.z));
    if (n.z > 0) return p;
    return {(1 - std::abs(p.y)) * sign_not_zero(p.x), (1 - std::abs(p.x)) * sign_not_zero(p.y)};
}

glm::dvec3 from_octahedron(glm::dvec2 p) {
    const double z = 1 - std::abs(p.x) - std::abs(p.y), below = std::max(-z, 0.0);
    return unit_or_up({p.x - sign_not_zero(p.x) * below, p.y - sign_not_zero(p.y) * below, z});
}

NormalCode octahedral(glm::dvec3 normal, int bits, bool precise) {
    const glm::dvec2 scaled = onto_octahedron(normal) * double(largest_snorm(bits));
    const auto code = [&](double x, double y) {
        return NormalCode{{as_stored(int(x), bits), as_stored(int(y), bits)}};
    };
    if (!precise) return code(std::round(scaled.x), std::round(scaled.y));
    NormalCode best;
    double nearest = 5;
    for (const double x : {std::floor(scaled.x), std::ceil(scaled.x)})
        for (const double y : {std::floor(scaled.y), std::ceil(scaled.y)}) {
            // Compare chords: at 16 bits the dot products of all four codes differ only in their last digits.
            const NormalCode one = code(x, y);
            const glm::dvec3 off =
                from_octahedron({from_snorm(one.channel[0], bits), from_snorm(one.channel[1], bits)}) - normal;
            if (const double chord = glm::dot(off, off); chord < nearest) nearest = chord, best = one;
        }
    return best;
}

template <class Channel>
NormalCode each(glm::dvec3 v, Channel channel) {
    return {{channel(v.x), channel(v.y), channel(v.z)}};
}

}  // namespace

std::span<const NormalFormatInfo> normal_formats() { return formats; }
const NormalFormatInfo& info_of(NormalFormat format) { return formats.at(size_t(format)); }

NormalCode encode_normal(NormalFormat format, glm::dvec3 normal) {
    const glm::dvec3 n = unit_or_up(normal);
    const int bits = info_of(format).bits;
    switch (format) {
        case NormalFormat::unorm8:
            return each(n, [](double x) { return unorm(x, 8); });
        case NormalFormat::unorm8_truncated:
            return each(n, [](double x) { return uint16_t((0.5 * x + 0.5) * 255); });
        case NormalFormat::snorm8:
            return each(n, [](double x) { return as_stored(int(std::lround(127 * x)), 8); });
        case NormalFormat::paired8:
            return each(n, [](double x) { return uint16_t(std::lround(127 * x) + 128); });
        case NormalFormat::rg8:
        case NormalFormat::rg16:
            return {{unorm(n.x, bits), unorm(n.y, bits)}};
        case NormalFormat::oct8:
        case NormalFormat::oct12:
        case NormalFormat::oct16:
            return octahedral(n, bits, false);
        case NormalFormat::oct8_precise:
        case NormalFormat::oct12_precise:
        case NormalFormat::oct16_precise:
            return octahedral(n, bits, true);
        case NormalFormat::half:
            return each(n, half_from_double);
    }
    return {};
}

glm::dvec3 decode_normal(NormalFormat format, NormalCode code) {
    const int bits = info_of(format).bits;
    const auto& c = code.channel;
    switch (format) {
        case NormalFormat::unorm8:
        case NormalFormat::unorm8_truncated:
            return unit_or_up({from_unorm(c[0], 8), from_unorm(c[1], 8), from_unorm(c[2], 8)});
        case NormalFormat::snorm8:
            return unit_or_up({from_snorm(c[0], 8), from_snorm(c[1], 8), from_snorm(c[2], 8)});
        case NormalFormat::paired8:
            return unit_or_up({c[0] - 128.0, c[1] - 128.0, c[2] - 128.0});
        case NormalFormat::rg8:
        case NormalFormat::rg16: {
            const glm::dvec2 xy(from_unorm(c[0], bits), from_unorm(c[1], bits));
            return unit_or_up({xy, std::sqrt(std::max(0.0, 1 - glm::dot(xy, xy)))});
        }
        case NormalFormat::oct8:
        case NormalFormat::oct8_precise:
        case NormalFormat::oct12:
        case NormalFormat::oct12_precise:
        case NormalFormat::oct16:
        case NormalFormat::oct16_precise:
            return from_octahedron({from_snorm(c[0], bits), from_snorm(c[1], bits)});
        case NormalFormat::half:
            return unit_or_up({double_from_half(c[0]), double_from_half(c[1]), double_from_half(c[2])});
    }
    return {0, 0, 1};
}

}  // namespace relief
