#include "assets/bricks_texel.h"
#include "assets/surface.h"

namespace relief::bricks {
namespace {

// Adds iron spots and crumbs of lime.
glm::vec3 with_specks(glm::vec3 color, glm::vec2 p, uint32_t seed) {
    const float bend = noise(p, 8, seed);
    const NearestPoint speck = cellular_noise((p + 3 * bend) / tile, glm::ivec2(102), seed + 1);
    Dice dice(speck.id);
    const float kind = dice.between(0, 1);
    if (kind > 0.12f && kind < 0.97f) return color;
    const float radius = dice.between(0.10f, 0.36f), spot = 1 - ramp(0.4f, 1.0f, speck.distance / radius);
    if (kind <= 0.12f) return color * (1 - 0.45f * spot);
    return glm::mix(color, light_of(186, 160, 136), 0.6f * spot);
}

glm::vec3 brick_light(glm::vec2 p, const Texel& texel) {
    const Brick& brick = *texel.brick;
    const uint32_t s = brick.seed;
    const float flash = ramp(-0.1f, 0.7f, brick.flash_share + noise(p, 128, 4, s + 30) + 0.25f * noise(p, 8, s + 31));
    glm::vec3 color = glm::mix(brick.tone, brick.flash, flash);
    color *= 1 + 0.20f * noise(p, 64, 4, s + 32) + 0.22f * grain_noise(p, s + 33);
    if (texel.fresh > 0) {
        const float fresh = texel.fresh * (0.65f + 0.5f * noise(p, 16, 2, s + 34));
        color = glm::mix(color, 1.15f * color + light_of(38, 22, 15), fresh);
    }
    color = with_specks(color, p, s + 35);
    color *= 1 - 0.3f * texel.pit;

    // Lime and sand from the joints, washed over the edges and over patches of the face.
    const float patchy = noise(p, 64, 4, 905);
    const float wash = ramp(-0.1f, 0.8f, patchy) * (0.25f + 0.75f * ramp(-26.0f, 0.0f, texel.outside));
    return glm::mix(color, light_of(168, 148, 128), 0.4f * wash);
}

glm::vec3 mortar_light(glm::vec2 p, float sand) {
    return light_of(170, 158, 140) * sand * (1 + 0.16f * noise(p, 64, 4, 906) + 0.14f * noise(p, 8, 2, 907));
}

}  // namespace

glm::vec3 light_at(glm::vec2 p, const Texel& texel, glm::vec2 hollow) {
    glm::vec3 color = texel.mortar < 1 && texel.brick ? brick_light(p, texel) : glm::vec3(0);
    if (texel.mortar > 0) color = glm::mix(color, mortar_light(p, texel.sand), texel.mortar);
    const float dirt = glm::clamp(hollow.x / 3.5f, -0.5f, 1.0f) + 0.6f * glm::clamp(hollow.y / 16, -0.3f, 1.0f);
    return color * (1 - 0.30f * dirt) * (1 + 0.10f * noise(p, 256, 2, 908));
}

}  // namespace relief::bricks
