#include "assets/staff/packed.h"

#include <cmath>

#include "framework/core/image/mips.h"
#include "framework/staff/reference/ambient_occlusion.h"

namespace relief {

Image make_packed(const SurfaceMaps& maps, double texels) {
    const Image colors = mip_chain(maps.albedo, ColorSpace::srgb).at(1);
    Image heights = mip_chain(maps.heights, ColorSpace::linear).at(1);
    heights.bits = 32;
    const Image open = occlusion_from_heights(heights, texels / 2, 8, 24);
    Image packed(heights.width, heights.height, 3, 8);
    for (int y = 0; y < packed.height; ++y)
        for (int x = 0; x < packed.width; ++x) {
            const float* color = colors.pixel(x, y);
            const float bright = 0.2126f * color[0] + 0.7152f * color[1] + 0.0722f * color[2];
            const float height = *heights.pixel(x, y);
            packed.pixel(x, y)[0] =
                glm::clamp(0.05f + 0.9f * ramp(0.25f, 0.75f, bright) * ramp(0.3f, 0.9f, height), 0.0f, 1.0f);
            packed.pixel(x, y)[1] = height;
            packed.pixel(x, y)[2] = *open.pixel(x, y);
        }
    return packed;
}

Image make_marble() {
    constexpr int side = 512;
    Image light(side, side, 3);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const glm::vec2 p = (glm::vec2(x, y) + 0.5f) / float(side);
            const glm::vec2 bent = p + 0.10f * glm::vec2(fractal_noise(p, 3, 4, 11), fractal_noise(p, 3, 4, 12));
            const float vein = std::exp(-28 * std::abs(fractal_noise(bent, 3, 3, 13))),
                        thin = std::exp(-60 * std::abs(fractal_noise(bent, 5, 4, 14)));
            const float cloud = 0.5f + 0.5f * glm::clamp(fractal_noise(p, 6, 5, 15) * 1.6f, -1.0f, 1.0f);
            const glm::vec3 stone = glm::mix(light_of(38, 52, 46), light_of(74, 92, 80), cloud);
            const glm::vec3 color =
                glm::mix(stone, light_of(205, 204, 186), glm::min(0.75f * vein + 0.4f * thin, 0.9f));
            for (int c = 0; c < 3; ++c) light.pixel(x, y)[c] = color[c];
        }
    return stored_albedo(light);
}

}  // namespace relief
