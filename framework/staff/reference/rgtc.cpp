#include "framework/staff/reference/rgtc.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "framework/core/base/error.h"

namespace relief {
namespace {

double end_value(int code, RgtcKind kind) {
    return kind == RgtcKind::unorm ? code / 255.0 : std::max(code / 127.0, -1.0);
}
double least(RgtcKind kind) { return kind == RgtcKind::unorm ? 0 : -1; }
double steps(RgtcKind kind) { return kind == RgtcKind::unorm ? 255 : 127; }

std::array<double, 16> clamped(std::array<double, 16> values, RgtcKind kind) {
    for (double& value : values) {
        if (std::isnan(value)) throw Error("a value of the block is not a number");
        value = std::clamp(value, least(kind), 1.0);
    }
    return values;
}

int nearest_index(const std::array<double, 8>& ramp, double value) {
    int best = 0;
    for (int i = 1; i < 8; ++i)
        if (std::abs(ramp[size_t(i)] - value) < std::abs(ramp[size_t(best)] - value)) best = i;
    return best;
}

RgtcBlock with_ends(int first, int second, const std::array<double, 16>& values, RgtcKind kind) {
    RgtcBlock block{first, second, {}};
    const std::array<double, 8> ramp = rgtc_ramp(first, second, kind);
    for (size_t i = 0; i < 16; ++i) block.indices[i] = nearest_index(ramp, values[i]);
    return block;
}

}  // namespace

std::array<uint8_t, 8> rgtc_bytes(const RgtcBlock& block) {
    std::array<uint8_t, 8> bytes = {uint8_t(block.first), uint8_t(block.second)};
    uint64_t bits = 0;
    for (size_t i = 0; i < 16; ++i) bits |= uint64_t(block.indices[i]) << (3 * i);
    for (size_t i = 0; i < 6; ++i) bytes[2 + i] = uint8_t(bits >> (8 * i));
    return bytes;
}

RgtcBlock rgtc_block(const std::array<uint8_t, 8>& bytes, RgtcKind kind) {
    const auto end = [&](uint8_t byte) { return kind == RgtcKind::unorm ? int(byte) : int(int8_t(byte)); };
    RgtcBlock block{end(bytes[0]), end(bytes[1]), {}};
    uint64_t bits = 0;
    for (size_t i = 0; i < 6; ++i) bits |= uint64_t(bytes[2 + i]) << (8 * i);
    for (size_t i = 0; i < 16; ++i) block.indices[i] = int(bits >> (3 * i) & 7);
    return block;
}

std::array<double, 8> rgtc_ramp(int first, int second, RgtcKind kind) {
    const double a = end_value(first, kind), b = end_value(second, kind);
    if (first > second)
        return {a,
                b,
                (6 * a + b) / 7,
                (5 * a + 2 * b) / 7,
                (4 * a + 3 * b) / 7,
                (3 * a + 4 * b) / 7,
                (2 * a + 5 * b) / 7,
                (a + 6 * b) / 7};
    return {a, b, (4 * a + b) / 5, (3 * a + 2 * b) / 5, (2 * a + 3 * b) / 5, (a + 4 * b) / 5, least(kind), 1};
}

std::array<double, 16> rgtc_decode(const RgtcBlock& block, RgtcKind kind) {
    const std::array<double, 8> ramp = rgtc_ramp(block.first, block.second, kind);
    std::array<double, 16> values;
    for (size_t i = 0; i < 16; ++i) values[i] = ramp[size_t(block.indices[i])];
    return values;
}

RgtcBlock rgtc_range_fit(const std::array<double, 16>& values, RgtcKind kind) {
    const std::array<double, 16> inside = clamped(values, kind);
    const auto [low, high] = std::minmax_element(inside.begin(), inside.end());
    return with_ends(int(std::lround(*high * steps(kind))), int(std::lround(*low * steps(kind))), inside, kind);
}

RgtcBlock rgtc_best(const std::array<double, 16>& values, RgtcKind kind) {
    const std::array<double, 16> inside = clamped(values, kind);
    RgtcBlock best = rgtc_range_fit(inside, kind);
    double best_error = rgtc_squared_error(best, inside, kind);
    const int low = kind == RgtcKind::unorm ? 0 : -127, high = kind == RgtcKind::unorm ? 255 : 127;
    for (int first = low; first <= high && best_error > 0; ++first)
        for (int second = low; second <= high; ++second) {
            const std::array<double, 8> ramp = rgtc_ramp(first, second, kind);
            double error = 0;
            for (size_t i = 0; i < 16 && error < best_error; ++i) {
                double nearest = std::numeric_limits<double>::infinity();
                for (const double value : ramp) nearest = std::min(nearest, (value - inside[i]) * (value - inside[i]));
                error += nearest;
            }
            if (error >= best_error) continue;
            best = with_ends(first, second, inside, kind);
            best_error = error;
        }
    return best;
}

double rgtc_squared_error(const RgtcBlock& block, const std::array<double, 16>& values, RgtcKind kind) {
    const std::array<double, 16> decoded = rgtc_decode(block, kind);
    double sum = 0;
    for (size_t i = 0; i < 16; ++i) sum += (decoded[i] - values[i]) * (decoded[i] - values[i]);
    return sum;
}

}  // namespace relief
