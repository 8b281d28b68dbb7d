// The individual properties of the wall's bricks, generated before any texel.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

#include "assets/noise.h"

namespace relief::bricks {

constexpr int columns = 4, courses = 8;
constexpr glm::vec2 cell(tile / columns, tile / courses);

/// A piece broken out of an edge.
struct Chip {
    glm::vec2 center, radius;
    float depth;
};

struct Brick {
    uint32_t seed;
    glm::vec2 center, half_size;  ///< of the foot, where the bevel meets the mortar
    float turn;                   ///< radians; small, so that sin x = x
    float rounding;               ///< difference of two edges' distances above which they no longer blend
    float bevel;                  ///< width
    float face;                   ///< height of the face's centre
    glm::vec2 slope;              ///< tilt of the face
    float roughness;              ///< of edge and face, about 1
    float pits;                   ///< average share of the pit positions that have a pit
    float folds;                  ///< depth of the folds that hand-made clay gets in the mould
    float spall;                  ///< amount of the face that has lost its skin; none below -0.2
    int chip_count;
    std::array<Chip, 8> chips;
    glm::vec3 tone, flash;  ///< linear colour of the body; of the parts changed by fire
    float flash_share;      ///< none below about -0.8
};

/// Row by row from the top; odd courses are shifted right by half a brick.
using Wall = std::array<std::array<Brick, columns>, courses>;
Wall lay_wall();

}  // namespace relief::bricks
