#include "assets/paving.h"

#include <array>

#include "assets/noise.h"

namespace relief {
namespace {

constexpr int rows = 4, columns = 4;
// The centre lines of the joints between rows, and between the slabs of each row. Joints of adjacent rows never meet.
// The last slab of a row continues beyond the border of the tile.
constexpr std::array<float, rows + 1> row_joints{0, 248, 480, 756, tile};
constexpr float slab_joints[rows][columns] = {
    {40, 316, 540, 800}, {170, 420, 690, 930}, {60, 290, 560, 810}, {150, 440, 640, 905}};

constexpr float joint_level = 1.2f, foot_level = 0.5f;

struct Slab {
    uint32_t seed;
    glm::vec2 center, half_size;  // of the foot
    float face;
    glm::vec2 slope;
    float wear;    // width of the rounded edge
    float ledges;  // approximate number of exposed layers of the stone
    glm::vec3 tone;
};

using Floor = std::array<std::array<Slab, columns>, rows>;

glm::vec3 pick_tone(Dice& dice) {
    static const std::array<glm::vec3, 5> tones{light_of(126, 130, 134), light_of(117, 122, 128),
                                                light_of(134, 136, 137), light_of(121, 126, 126),
                                                light_of(133, 132, 129)};
    return tones[dice.bits() % tones.size()];
}

Slab lay_slab(int column, int row) {
    Slab slab{};
    slab.seed = hash(column, row, 77);
    Dice dice(slab.seed);
    const float left = slab_joints[row][column];
    const float right = column + 1 < columns ? slab_joints[row][column + 1] : slab_joints[row][0] + tile;
    const glm::vec2 low(left, row_joints[row]), high(right, row_joints[row + 1]);
    slab.center = (low + high) / 2.0f + glm::vec2{dice.between(-0.7f, 0.7f), dice.between(-0.7f, 0.7f)};
    slab.half_size = (high - low) / 2.0f - dice.between(2.2f, 3.6f);
    slab.face = dice.between(8.5f, 9.3f);
    slab.slope = {dice.between(-0.004f, 0.004f), dice.between(-0.004f, 0.004f)};
    slab.wear = dice.between(10, 16);
    slab.ledges = dice.between(1.0f, 3.2f);
    slab.tone = pick_tone(dice);
    slab.tone *= dice.between(0.92f, 1.08f);
    return slab;
}

struct Texel {
    float height;
    float joint;       // 0 stone, 1 joint filling
    float outside;     // distance from the foot of the nearest slab; negative on the slab
    float layer;       // height in layers of the stone
    const Slab* slab;  // the nearest slab
};

// The stone splits along its layers: plateaus with low, worn ledges between them.
float layer_at(const Slab& slab, glm::vec2 at) {
    const float height = slab.ledges * noise(at, 128, 5, slab.seed + 1), whole = glm::floor(height);
    return whole + ramp(0.3f, 0.7f, height - whole);
}

float face_detail(const Slab& slab, glm::vec2 at) {
    const uint32_t s = slab.seed;
    float height = 0.8f * noise(at, 128, s + 6) + 0.6f * noise(at, 64, s + 7) + 0.28f * noise(at, 32, s + 8) +
                   0.22f * noise(at, 16, s + 9) + 0.13f * noise(at, 8, s + 10) + 0.08f * grain_noise(at, s + 11);
    const NearestPoint pit = cellular_noise((at + 2.5f * noise(at, 8, s + 13)) / tile, glm::ivec2(64), s + 14);
    Dice dice(pit.id);
    const float radius = dice.between(0.08f, 0.24f);
    if (dice.chance(0.3f)) height -= 3.5f * radius * (1 - ramp(0.2f, 1.0f, pit.distance / radius));
    return height;
}

void add_slab(Texel& texel, const Slab& slab, glm::vec2 p) {
    glm::vec2 q = p - slab.center;
    q -= tile * glm::round(q / tile);
    const glm::vec2 at = q + slab.center, beyond = glm::abs(q) - slab.half_size;
    float outside = smooth_max(beyond.x, beyond.y, slab.wear);
    if (outside > texel.outside + 6 || outside > 10) return;
    const uint32_t s = slab.seed;
    if (outside > -30) {
        const float bites = glm::max(0.0f, noise(at, 32, 3, s + 20) - 0.25f);
        outside += 1.0f * noise(at, 64, s + 21) + 0.7f * noise(at, 16, s + 22) + 6 * bites;
    }
    float height = foot_level, layer = 0;
    if (outside < 0) {
        const float t = glm::min(1.0f, -outside / slab.wear);
        const float edge = 1 - (1 - t) * (1 - t);
        layer = layer_at(slab, at);
        height += edge * (slab.face + glm::dot(slab.slope, q) + 0.75f * layer + face_detail(slab, at) - foot_level);
    }
    if (outside < texel.outside) texel.outside = outside, texel.slab = &slab, texel.layer = layer;
    texel.height = glm::max(texel.height, height);
}

Texel relief_at(glm::vec2 p, const Floor& floor) {
    p += 1.5f * glm::vec2(noise(p, 128, 701), noise(p, 128, 702));
    Texel texel{.height = 0, .joint = 0, .outside = 10, .layer = 0, .slab = nullptr};
    for (int row = 0; row < rows; ++row) {
        const float middle = (row_joints[row] + row_joints[row + 1]) / 2, away = p.y - middle;
        if (glm::abs(away - tile * glm::round(away / tile)) > row_joints[row + 1] - middle + 12) continue;
        for (const Slab& slab : floor[row]) add_slab(texel, slab, p);
    }
    if (texel.outside > -8) {
        const float sand =
            joint_level + 0.8f * noise(p, 64, 2, 703) + 0.35f * noise(p, 8, 704) + 0.25f * grain_noise(p, 705);
        texel.joint = ramp(-0.8f, 1.2f, sand - texel.height);
        texel.height = smooth_max(texel.height, sand, 1.5f);
    }
    return texel;
}

glm::vec3 stone_light(glm::vec2 p, const Texel& texel) {
    const uint32_t s = texel.slab->seed;
    const glm::vec2 bent = p + 20.0f * glm::vec2(noise(p, 32, s + 30), noise(p, 32, s + 31));
    const float clouds = noise(bent, 128, 4, s + 32);
    glm::vec3 color =
        texel.slab->tone * (1 + 0.20f * clouds + 0.10f * noise(p, 8, s + 33) + 0.24f * grain_noise(p, s + 34));
    color *= 1 + 0.05f * texel.layer;
    // Iron stains in the stone.
    const float rust = ramp(0.1f, 0.8f, noise(bent, 128, 3, s + 37));
    return color * glm::mix(glm::vec3(1), glm::vec3(1.08f, 0.98f, 0.86f), rust);
}

glm::vec3 sand_light(glm::vec2 p) {
    const glm::vec3 sand = light_of(112, 107, 98) * (1 + 0.2f * noise(p, 16, 2, 710) + 0.25f * grain_noise(p, 711));
    const glm::vec3 moss = light_of(84, 90, 70) * (1 + 0.35f * grain_noise(p, 712));
    return glm::mix(sand, moss, ramp(-0.05f, 0.5f, noise(p, 128, 4, 713)));
}

glm::vec3 light_at(glm::vec2 p, const Texel& texel, glm::vec2 hollow) {
    glm::vec3 color = texel.slab && texel.joint < 1 ? stone_light(p, texel) : glm::vec3(0);
    if (texel.joint > 0) color = glm::mix(color, sand_light(p), texel.joint);
    const float dirt = glm::clamp(hollow.x / 2, -0.4f, 1.0f) + 0.6f * glm::clamp(hollow.y / 5, -0.3f, 1.0f);
    return color * (1 - 0.22f * dirt) * (1 + 0.10f * noise(p, 256, 2, 714));
}

}  // namespace

SurfaceMaps make_paving(int size) {
    Floor floor;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) floor[row][column] = lay_slab(column, row);
    return make_surface(
        size, paving_depth_in_texels, [&](glm::vec2 p) { return relief_at(p, floor); }, light_at);
}

}  // namespace relief
