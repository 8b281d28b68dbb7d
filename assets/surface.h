// What a generated surface consists of, and what its generators share.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "assets/noise.h"
#include "framework/image/image.h"

namespace relief {

/// Two maps that tile in u and v. `albedo`: 3 channels, sRGB, 8 bits. `heights`: 1 channel, 16 bits, every
/// value already rounded as in a file, so that normals made before and after storing agree.
struct SurfaceMaps {
    Image albedo;
    Image heights;
};

/// A colour as painters give it (sRGB, 0..255) as light.
glm::vec3 light_of(int red, int green, int blue);

/// A tiling one-channel image, smoothed with a bell about `radius` texels wide (three box filters).
Image blurred(const Image& image, int radius);

/// Heights in texels, 0 to `depth`, to [0, 1] in steps of 16 bits.
Image stored_heights(const Image& texels, double depth);

/// Light, 3 channels, to sRGB in steps of 8 bits.
Image stored_albedo(const Image& light);

/// `size` by `size` texels, first the relief of all, then the light from each. `relief_at(p)` gives a value with a
/// `height`, in texels; `light_at(p, that value, hollow)` the light, where `hollow` is how much lower the texel lies
/// than the mean about 4 and 24 texels around it. All lengths are for a map of 1024, also in `p`.
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
