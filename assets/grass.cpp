#include "assets/grass.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "assets/surface.h"

namespace relief {

GrassMaps make_grass() {
    constexpr int n = grass_texels;
    Image light(n, n, 3), heights(n / 2, n / 2, 1);
    const glm::vec3 soil = light_of(34, 33, 22);
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x)
            for (int c = 0; c < 3; ++c) light.pixel(x, y)[c] = soil[c];
    const glm::vec3 dark = light_of(40, 58, 24), fresh = light_of(98, 122, 46), dry = light_of(136, 128, 72);
    for (uint32_t blade = 0; blade < 16000; ++blade) {
        Dice dice(hash(blade, 81));
        const glm::vec2 foot{dice.between(0, n), dice.between(0, n)};
        const float angle = dice.between(0, 6.2832f), length = dice.between(8, 30), bend = dice.between(-0.9f, 0.9f);
        // Some patches of the lawn are fresher. Later blades lie higher and get more light.
        const float fresher = 0.5f + 0.9f * noise(foot * (tile / n), 256, 2, 82), high = float(blade) / 16000;
        glm::vec3 color = glm::mix(dark, fresh, glm::clamp(fresher + dice.between(-0.35f, 0.35f), 0.0f, 1.0f));
        if (dice.chance(0.07f)) color = glm::mix(color, dry, 0.7f);
        color *= (0.35f + 0.75f * high) * dice.between(0.75f, 1.2f);
        glm::vec2 place = foot;
        for (float at = 0; at < length; at += 0.5f) {
            const float turn = angle + bend * at / length;
            place += 0.5f * glm::vec2(std::cos(turn), std::sin(turn));
            const float wide = 1.1f * (1 - at / length);
            for (int dy = -2; dy <= 2; ++dy)
                for (int dx = -2; dx <= 2; ++dx) {
                    const glm::ivec2 texel = glm::ivec2(glm::floor(place)) + glm::ivec2(dx, dy);
                    const float cover =
                        glm::clamp(wide + 0.5f - glm::length(glm::vec2(texel) + 0.5f - place), 0.0f, 1.0f);
                    if (cover <= 0) continue;
                    const glm::ivec2 wrapped = ((texel % n) + n) % n;
                    float* into = light.pixel(wrapped.x, wrapped.y);
                    const glm::vec3 lit = color * (0.7f + 0.5f * at / length);
                    for (int c = 0; c < 3; ++c) into[c] = glm::mix(into[c], lit[c], 0.6f * cover);
                    float& height = *heights.pixel(wrapped.x / 2, wrapped.y / 2);
                    // A blade bends up from its foot, and the middle of it is higher than its edges.
                    height = std::max(height, cover * (0.3f + 0.4f * high + 0.3f * at / length));
                }
        }
    }
    return {.albedo = stored_albedo(light), .heights = std::move(heights)};
}

}  // namespace relief
