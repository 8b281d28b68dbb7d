#include "framework/library/maps/bc1.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>

namespace relief {
namespace {

/// Returns the color as a block stores an end: 5, 6 and 5 bits, read back as 8 bits by repeating the highest bits.
glm::dvec3 as_end(glm::dvec3 color) {
    constexpr std::array bits = {5, 6, 5};
    for (int c = 0; c < 3; ++c) {
        const int code = int(std::lround(std::clamp(color[c], 0.0, 1.0) * ((1 << bits[size_t(c)]) - 1)));
        const int shift = 8 - bits[size_t(c)];
        color[c] = ((code << shift) | (code >> (bits[size_t(c)] - shift))) / 255.0;
    }
    return color;
}

/// Returns the principal axis of the colors, by power iteration; (1, 1, 1) if they are equal.
glm::dvec3 principal_axis(const std::array<glm::dvec3, 16>& colors, glm::dvec3 mean) {
    glm::dmat3 covariance(0);
    for (const glm::dvec3& color : colors) covariance += glm::outerProduct(color - mean, color - mean);
    // Begin with the longest column: it is not perpendicular to the axis.
    glm::dvec3 axis = covariance[0];
    for (const int c : {1, 2})
        if (glm::length(covariance[c]) > glm::length(axis)) axis = covariance[c];
    if (glm::length(axis) == 0) return glm::dvec3(1);
    for (int i = 0; i < 16; ++i) axis = glm::normalize(covariance * glm::normalize(axis));
    return axis;
}

std::array<glm::dvec3, 16> block_through_bc1(std::array<glm::dvec3, 16> colors) {
    glm::dvec3 mean(0);
    for (const glm::dvec3& color : colors) mean += color / 16.0;
    const glm::dvec3 axis = principal_axis(colors, mean);
    const auto [low, high] = std::minmax_element(colors.begin(), colors.end(), [&](glm::dvec3 a, glm::dvec3 b) {
        return glm::dot(a, axis) < glm::dot(b, axis);
    });
    const glm::dvec3 first = as_end(*high), second = as_end(*low);
    const std::array<glm::dvec3, 4> line = {first, (2.0 * first + second) / 3.0, (first + 2.0 * second) / 3.0, second};
    for (glm::dvec3& color : colors)
        color = *std::min_element(line.begin(), line.end(), [&](glm::dvec3 a, glm::dvec3 b) {
            return glm::dot(a - color, a - color) < glm::dot(b - color, b - color);
        });
    return colors;
}

}  // namespace

Image through_bc1(const Image& picture) {
    Image result(picture.width, picture.height, 3, 8);
    const auto row = [&](int y) { return picture.height - 1 - std::min(y, picture.height - 1); };  // y grows upwards
    for (int bottom = 0; bottom < picture.height; bottom += 4)
        for (int left = 0; left < picture.width; left += 4) {
            std::array<glm::dvec3, 16> colors;
            for (int i = 0; i < 16; ++i)
                for (int c = 0; c < 3; ++c) {
                    const float value =
                        picture.pixel(std::min(left + i % 4, picture.width - 1), row(bottom + i / 4))[c];
                    colors[size_t(i)][c] = value > 0 ? std::min(double(value), 1.0) : 0.0;
                }
            colors = block_through_bc1(colors);
            for (int i = 0; i < 16; ++i) {
                const int x = left + i % 4, y = bottom + i / 4;
                if (x >= picture.width || y >= picture.height) continue;
                for (int c = 0; c < 3; ++c)
                    result.pixel(x, row(y))[c] = float(std::lround(255 * colors[size_t(i)][c])) / 255;
            }
        }
    return result;
}

}  // namespace relief
