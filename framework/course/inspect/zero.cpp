#include "framework/course/inspect/zero.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <vector>

namespace relief::inspect {
namespace {

double length_off(const glm::dvec3& code, StoredZero zero) {
    switch (zero) {
        case StoredZero::half:
            return glm::length((code - 127.5) / 127.5) - 1;
        case StoredZero::paired:
            return glm::length((code - 128.0) / 127.0) - 1;
        case StoredZero::cut:
            return glm::length((code - 127.0) / 127.5) - 1;
    }
    return 0;
}

}  // namespace

ZeroTest test_zero(const Image& normals) {
    // Counts each colour once: texels of one colour have the same rounding error, so they add no evidence.
    std::vector<uint64_t> seen(size_t{1} << 18);  // a bit for each colour
    for (size_t i = 0; i < normals.pixel_count(); ++i) {
        size_t index = 0;
        for (size_t c = 0; c < 3; ++c)
            index = index << 8 |
                    size_t(std::clamp(std::lround(255.0 * normals.values[i * size_t(normals.channels) + c]), 0L, 255L));
        seen[index / 64] |= uint64_t{1} << index % 64;
    }
    ZeroTest result;
    std::array<double, 3> squares{};
    std::array<std::array<double, 3>, 3> apart{}, apart_squares{};  // difference of the squared errors of two zeros
    for (size_t index = 0; index < seen.size() * 64; ++index) {
        if (seen[index / 64] == 0) index |= 63;
        if ((seen[index / 64] >> index % 64 & 1) == 0) continue;
        const glm::dvec3 code(double(index >> 16), double(index >> 8 & 255), double(index & 255));
        std::array<double, 3> off{};
        for (size_t z = 0; z < 3; ++z) off[z] = length_off(code, StoredZero(z));
        const bool straight = std::hypot(code.x - 127.5, code.y - 127.5) < 8;
        const bool normal = std::any_of(off.begin(), off.end(), [](double one) { return std::abs(one) < 0.02; });
        if (straight || !normal) continue;
        ++result.colors;
        for (size_t z = 0; z < 3; ++z) {
            squares[z] += off[z] * off[z];
            for (size_t other = 0; other < 3; ++other) {
                const double difference = off[other] * off[other] - off[z] * off[z];
                apart[z][other] += difference, apart_squares[z][other] += difference * difference;
            }
        }
    }
    const double count = double(result.colors);
    if (result.colors < 50) {
        result.why = "too few different slopes: flat is 128 by every rule";
        return result;
    }
    for (size_t z = 0; z < 3; ++z) result.rms[z] = std::sqrt(squares[z] / count);
    const size_t best = size_t(std::min_element(squares.begin(), squares.end()) - squares.begin());
    // Rounding alone leaves 0.0023 rms.
    if (result.rms[best] > 0.0035) {
        result.why = "lengths are off by more than rounding to 8 bits makes";
        return result;
    }
    for (size_t other = 0; other < 3; ++other) {
        if (other == best) continue;
        const double mean = apart[best][other] / count,
                     deviation = std::sqrt(std::max(0.0, apart_squares[best][other] / count - mean * mean) / count);
        if (mean > 4 * deviation) continue;
        result.why = "two rules fit the lengths alike";
        return result;
    }
    result.best = best;
    return result;
}

}  // namespace relief::inspect
