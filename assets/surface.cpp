#include "assets/surface.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "framework/core/image/color.h"

namespace relief {
namespace {

// One box filter along x by a running sum, in integers: a sum of floats would drift.
Image box_filtered(const Image& image, int radius) {
    constexpr float steps = 1 << 16;
    const int width = image.width;
    Image result(width, image.height, 1);
    std::vector<int64_t> row(width);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < width; ++x) row[x] = static_cast<int64_t>(*image.pixel(x, y) * steps);
        int64_t sum = 0;
        for (int k = -radius; k <= radius; ++k) sum += row[(k + width) % width];
        for (int x = 0; x < width; ++x) {
            *result.pixel(x, y) = static_cast<float>(sum) / (steps * (2 * radius + 1));
            sum += row[(x + radius + 1) % width] - row[(x - radius + width) % width];
        }
    }
    return result;
}

Image transposed(const Image& image) {
    Image result(image.height, image.width, 1);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) *result.pixel(y, x) = *image.pixel(x, y);
    return result;
}

}  // namespace

glm::vec3 light_of(int red, int green, int blue) {
    const auto light = [](int stored) { return linear_from_srgb8(static_cast<unsigned char>(stored)); };
    return {light(red), light(green), light(blue)};
}

Image blurred(const Image& image, int radius) {
    Image result = image;
    for (int axis = 0; axis < 2; ++axis) {
        for (int pass = 0; pass < 3; ++pass) result = box_filtered(result, std::max(1, radius / 2));
        result = transposed(result);
    }
    return result;
}

Image stored_heights(const Image& texels, double depth) {
    Image result(texels.width, texels.height, 1, 16);
    for (size_t i = 0; i < result.values.size(); ++i) {
        const double height = std::clamp(texels.values[i] / depth, 0.0, 1.0);
        result.values[i] = static_cast<float>(std::round(height * 65535) / 65535);
    }
    return result;
}

Image stored_albedo(const Image& light) {
    Image result(light.width, light.height, 3, 8);
    for (size_t i = 0; i < result.values.size(); ++i)
        result.values[i] = static_cast<float>(srgb8_from_linear(light.values[i])) / 255;
    return result;
}

}  // namespace relief
