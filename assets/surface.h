// The maps of a generated surface, and functions that its generators share.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "assets/noise.h"
#include "framework/core/image/image.h"

namespace relief {

/// Two maps that tile in u and v. `albedo`: 3 channels, sRGB, 8 bits. `heights`: 1 channel, 16 bits. All values are
/// rounded as in a file, so that normals made before and after storing agree.
struct SurfaceMaps {
    Image albedo;
    Image heights;
};

/// Converts an sRGB colour (0 to 255) to linear light.
glm::vec3 light_of(int red, int green, int blue);

/// Returns a tiling one-channel image, smoothed by a bell filter about `radius` texels wide (three box filters).
Image blurred(const Image& image, int radius);

/// Converts heights from [0, depth] texels to [0, 1], quantised to 16 bits.
Image stored_heights(const Image& texels, double depth);

/// Converts linear light, 3 channels, to sRGB, quantised to 8 bits.
Image stored_albedo(const Image& light);

/// Generates maps of `size` by `size` texels: first the relief of all texels, then their light. `relief_at(p)` returns
/// a value with a `height` in texels. `light_at(p, that value, hollow)` returns linear light. `hollow` is the texel's
/// depth below the mean of about 4 and 24 texels around it. All lengths, including `p`, are for a map of 1024 texels.
template <class Relief, class Light>
SurfaceMaps make_surface(int size, double depth, Relief relief_at, Light light_at) {
    const auto place = [=](int x, int y) { return (glm::vec2(x, y) + 0.5f) * (tile / size); };
    std::vector<decltype(relief_at(glm::vec2()))> texels;
    texels.reserve(static_cast<size_t>(size) * size);
    Image heights(size, size, 1);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            texels.push_back(relief_at(place(x, y)));
            *heights.pixel(x, y) = texels.back().height;
        }

    const Image near = blurred(heights, 4 * size / 1024), far = blurred(heights, 24 * size / 1024);
    Image light(size, size, 3);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const auto& texel = texels[static_cast<size_t>(y) * size + x];
            const glm::vec2 around(*near.pixel(x, y), *far.pixel(x, y));
            const glm::vec3 color = light_at(place(x, y), texel, around - texel.height);
            for (int c = 0; c < 3; ++c) light.pixel(x, y)[c] = color[c];
        }
    return {.albedo = stored_albedo(light), .heights = stored_heights(heights, depth)};
}

}  // namespace relief
