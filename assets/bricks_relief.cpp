#include "assets/bricks_texel.h"

namespace relief::bricks {
namespace {

// Beyond this distance from its foot, a brick has no effect.
constexpr float reach = 18;
constexpr float mortar_level = 2.0f, foot_level = -0.2f;

// From 0 at the foot to 1 on the face: a short hollow, a straight flank, a round shoulder. `t` is in bevel widths. The
// flank is 1.7 times as steep as a straight line from foot to face.
float bevel_profile(float t) {
    constexpr float flank_begin = 0.10f, flank_end = 0.28f;
    constexpr float slope = 2 / (1 + flank_end - flank_begin);
    if (t <= 0) return 0;
    if (t < flank_begin) return slope * t * t / (2 * flank_begin);
    if (t < flank_end) return slope * (t - flank_begin / 2);
    if (t < 1) return 1 - slope * (1 - t) * (1 - t) / (2 * (1 - flank_end));
    return 1;
}

// Returns the signed distance to the foot, negative inside. Two edges at similar distance blend at any depth: corners
// are round, and bevels meet without a mitre.
float distance_to_foot(const Brick& brick, glm::vec2 q) {
    const glm::vec2 beyond = glm::abs(q) - brick.half_size;
    return smooth_max(beyond.x, beyond.y, brick.rounding);
}

float folds(const Brick& brick, glm::vec2 at) {
    const uint32_t s = brick.seed;
    const float where = ramp(-0.05f, 0.4f, noise(at, 128, s + 9));
    if (where == 0) return 0;
    const glm::vec2 bent = at + 9.0f * glm::vec2(noise(at, 64, s + 6), noise(at, 32, s + 7));
    return where * (1 - ramp(0.0f, 0.15f, glm::abs(gradient_noise(bent / tile, {10, 42}, s + 8))));
}

// Returns the depth in a pit, from 0 to 1, and lowers `height`. Pits lie on a lattice of `length` texels.
float pit(uint32_t seed, glm::vec2 at, int length, float share, float& height) {
    const NearestPoint point = cellular_noise(at / tile, glm::ivec2(static_cast<int>(tile) / length), seed + length);
    Dice dice(point.id);
    // The share varies across a pit, so the pit must fade: a threshold would cut it in two.
    const float open = ramp(0.0f, 0.06f, share - dice.between(0, 1));
    if (open == 0) return 0;
    const float radius = dice.between(0.12f, 0.36f);
    const float inside = open * (1 - ramp(0.25f, 1.0f, point.distance / radius));
    height -= inside * radius * length * 0.4f;
    return inside;
}

struct Face {
    float height, fresh, pit;
};

Face face_at(const Brick& brick, glm::vec2 at) {
    const uint32_t s = brick.seed;
    Face face{};
    face.height =
        1.2f * noise(at, 64, s + 1) + 0.7f * noise(at, 32, s + 2) +
        brick.roughness * (0.40f * noise(at, 16, s + 3) + 0.25f * noise(at, 8, s + 4) + 0.18f * grain_noise(at, s + 5));
    if (brick.folds > 0) face.height -= brick.folds * folds(brick, at);

    if (brick.spall > -0.2f) {
        face.fresh = ramp(0.24f, 0.32f, brick.spall + noise(at, 128, 2, s + 10) + 0.12f * noise(at, 16, s + 15));
        if (face.fresh > 0) face.height -= face.fresh * (1.6f + 0.6f * noise(at, 16, 3, s + 11));
    }

    // Pits come in clusters.
    const float share = 2 * brick.pits * ramp(-0.3f, 0.5f, noise(at, 64, s + 12));
    if (share == 0) return face;
    const glm::vec2 bent = at + 3.2f * glm::vec2(noise(at, 8, s + 13), noise(at, 8, s + 14));
    for (const int length : {8, 16, 32})
        face.pit = glm::max(face.pit, pit(s + 40, bent, length, length == 32 ? 0.4f * share : share, face.height));
    return face;
}

// Returns the irregularity of the foot's outline, seen from the front.
float edge_noise(const Brick& brick, glm::vec2 at) {
    const uint32_t s = brick.seed;
    const float bites = glm::max(0.0f, noise(at, 32, 2, s + 24) - 0.22f);
    return 1.5f * noise(at, 64, s + 20) +
           brick.roughness *
               (1.1f * noise(at, 32, s + 21) + 0.9f * noise(at, 16, s + 22) + 0.5f * noise(at, 8, s + 23)) +
           9 * bites;
}

void break_chips(const Brick& brick, glm::vec2 q, glm::vec2 at, Face& face) {
    const uint32_t s = brick.seed;
    for (int i = 0; i < brick.chip_count; ++i) {
        const Chip& chip = brick.chips[i];
        glm::vec2 r = q - chip.center;
        if (glm::abs(r.x) > chip.radius.x + 5 || glm::abs(r.y) > chip.radius.y + 5) continue;
        r += 3.5f * glm::vec2(noise(at, 16, 3, s + 26), noise(at, 16, 3, s + 27));
        const float inside = 1 - glm::length(r / chip.radius);
        if (inside <= 0) continue;
        face.height -= chip.depth * glm::min(1.0f, 1.6f * inside) * (1 + 0.25f * noise(at, 16, 2, s + 28));
        face.fresh = glm::max(face.fresh, ramp(0.0f, 0.2f, inside));
    }
}

void add_brick(Texel& texel, const Brick& brick, glm::vec2 p) {
    glm::vec2 q = p - brick.center;
    q -= tile * glm::round(q / tile);
    q = {q.x + brick.turn * q.y, q.y - brick.turn * q.x};
    float outside = distance_to_foot(brick, q);
    if (outside > reach) return;
    const glm::vec2 at = q + brick.center;  // the noise rotates with the brick
    if (outside > -brick.bevel * 2) outside += edge_noise(brick, at);

    Face face{};
    float height = foot_level - 0.2f * glm::max(outside, 0.0f);
    if (outside < 0) {
        face = face_at(brick, at);
        break_chips(brick, q, at, face);
        const float bevel = brick.bevel * (1 + 0.5f * noise(at, 64, brick.seed + 29));
        const float shape = bevel_profile(-outside / bevel);
        height += shape * (brick.face + glm::dot(brick.slope, q) - foot_level) + ramp(0.0f, 0.5f, shape) * face.height;
    }
    if (outside < texel.outside) {
        texel.brick = &brick;
        texel.outside = outside;
        texel.fresh = face.fresh;
        texel.pit = face.pit;
    }
    texel.height = glm::max(texel.height, height);
}

void add_mortar(Texel& texel, glm::vec2 p) {
    // The trowel has left more mortar against some bricks than against others.
    const float rise = glm::max(0.0f, noise(p, 64, 3, 901) + 0.1f) * (1 - ramp(-2.0f, 12.0f, texel.outside));

    const NearestPoint grain = cellular_noise(p / tile, glm::ivec2(224), 902);
    Dice dice(grain.id);
    const float size = dice.between(0, 1), tone = dice.between(-0.22f, 0.22f);
    const float bump = 1 - ramp(0.0f, 0.75f, grain.distance);
    texel.sand = 1 + bump * (tone < -0.2f ? -0.35f : tone);

    const float height = mortar_level + 5 * rise + 1.0f * noise(p, 64, 903) + 0.8f * noise(p, 16, 904) +
                         0.5f * noise(p, 8, 905) + 1.1f * size * size * bump;
    texel.mortar = ramp(-1.0f, 2.0f, height - texel.height);
    texel.height = smooth_max(texel.height, height, 2.0f);
}

}  // namespace

Texel relief_at(glm::vec2 p, const Wall& wall) {
    // Courses are not perfectly straight.
    p += glm::vec2(2.0f * noise(p, 128, 801), 2.5f * noise(p, 256, 802));
    Texel texel{};
    texel.height = -3;
    texel.outside = reach;
    const int course = static_cast<int>(glm::floor(p.y / cell.y));
    for (int j = course - 1; j <= course + 1; ++j) {
        if (glm::abs(p.y - (j + 0.5f) * cell.y) > cell.y / 2 + reach) continue;
        const int row = (j + courses) % courses;
        const float along = p.x / cell.x - (row % 2 ? 0.5f : 0.0f);
        const int column = static_cast<int>(glm::floor(along));
        for (int i = column - 1; i <= column + 1; ++i)
            if (glm::abs(along - (i + 0.5f)) * cell.x <= cell.x / 2 + reach)
                add_brick(texel, wall[row][(i + columns) % columns], p);
    }
    if (texel.outside > -16) add_mortar(texel, p);
    return texel;
}

}  // namespace relief::bricks
