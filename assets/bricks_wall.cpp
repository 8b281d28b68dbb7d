#include "assets/bricks_wall.h"

#include "assets/surface.h"

namespace relief::bricks {
namespace {

struct Tone {
    float share;
    glm::vec3 light;
};

glm::vec3 pick_tone(Dice& dice) {
    static const std::array<Tone, 8> tones{{
        {0.22f, light_of(146, 84, 66)},   // red
        {0.20f, light_of(135, 76, 61)},   // deep red
        {0.16f, light_of(155, 95, 74)},   // light red
        {0.10f, light_of(159, 105, 79)},  // orange
        {0.14f, light_of(126, 83, 67)},   // brown
        {0.10f, light_of(116, 73, 62)},   // red-brown
        {0.05f, light_of(101, 73, 65)},   // burnt
        {0.03f, light_of(152, 110, 87)},  // buff
    }};
    float left = dice.between(0, 1);
    for (const Tone& tone : tones)
        if ((left -= tone.share) < 0) return tone.light;
    return tones[0].light;
}

Chip break_edge(Dice& dice, glm::vec2 half_size) {
    glm::vec2 place{dice.between(-1, 1), dice.between(-1, 1)};
    if (dice.chance(0.7f))
        place.y = glm::sign(place.y);  // one of the long edges
    else
        place.x = glm::sign(place.x);
    if (dice.chance(0.35f)) place = glm::sign(place);  // a corner
    const float size = dice.between(0, 1), radius = glm::mix(10.0f, 34.0f, size * size);
    // Deeper chips would have flanks too steep for a height field.
    return {.center = place * (half_size - 3.0f),
            .radius = radius * glm::vec2{dice.between(0.9f, 1.6f), dice.between(0.7f, 1.1f)},
            .depth = radius * dice.between(0.25f, 0.4f)};
}

Brick lay_brick(int column, int course) {
    Brick brick{};
    brick.seed = hash(column, course, 2024);
    Dice dice(brick.seed);
    brick.center = cell * glm::vec2(column + (course % 2 ? 1.0f : 0.5f), course + 0.5f) +
                   glm::vec2{dice.between(-2.5f, 2.5f), dice.between(-1.5f, 1.5f)};
    brick.half_size = cell * 0.5f - glm::vec2{dice.between(2.0f, 5.0f), dice.between(2.0f, 4.5f)};
    brick.turn = dice.between(-0.012f, 0.012f);
    brick.rounding = dice.between(14, 32);
    brick.bevel = dice.between(22, 30);
    brick.face = dice.between(19.8f, 22.0f);
    brick.slope = {dice.between(-0.010f, 0.010f), dice.between(-0.024f, 0.024f)};
    brick.roughness = dice.between(0.7f, 1.4f);
    brick.pits = dice.between(0, 1);
    brick.pits = 0.03f + 0.40f * brick.pits * brick.pits;
    brick.folds = dice.chance(0.6f) ? dice.between(0.5f, 1.6f) : 0.0f;
    brick.spall = dice.between(-0.9f, 0.3f);
    brick.chip_count = 2 + static_cast<int>(dice.between(0, 6));
    for (int i = 0; i < brick.chip_count; ++i) brick.chips[i] = break_edge(dice, brick.half_size);
    brick.tone = pick_tone(dice);
    brick.tone *= dice.between(0.92f, 1.10f);
    brick.flash = glm::mix(brick.tone, pick_tone(dice), 0.75f);
    brick.flash *= dice.between(0.78f, 1.02f);
    brick.flash_share = dice.between(-0.5f, 0.2f);
    return brick;
}

}  // namespace

Wall lay_wall() {
    Wall wall;
    for (int course = 0; course < courses; ++course)
        for (int column = 0; column < columns; ++column) wall[course][column] = lay_brick(column, course);
    return wall;
}

}  // namespace relief::bricks
