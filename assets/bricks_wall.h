// How the bricks of the wall differ from each other, before any texel is made.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

#include "assets/noise.h"

namespace relief::bricks {

constexpr int columns = 4, courses = 8;
constexpr glm::vec2 cell(tile / columns, tile / courses);

/// A piece broken out of the edge.
struct Chip {
    glm::vec2 center, radius;
    float depth;
};

struct Brick {
    uint32_t seed;
    glm::vec2 center, half_size;  ///< of the foot, where the bevel meets the mortar
    float turn;                   ///< radians, small enough to stand for its sine
    float rounding;               ///< how different two edges' distances are where they no longer blend
    float bevel;                  ///< width
    float face;                   ///< height of the middle of the face
    glm::vec2 slope;              ///< of the whole face
    float roughness;              ///< of edge and face, about 1
    float pits;                   ///< share of the places for pits that have one, on average
    float folds;                  ///< depth of the folds that hand-made clay takes on in the mould
    float spall;                  ///< how much of the face has lost its skin: none below -0.2
    int chip_count;
    std::array<Chip, 8> chips;
    glm::vec3 tone, flash;  ///< light from the body, and from where the fire has changed it
    float flash_share;      ///< none below about -0.8
};

/// Row by row from the top; odd courses are half a brick further to the right.
using Wall = std::array<std::array<Brick, columns>, courses>;
Wall lay_wall();

}  // namespace relief::bricks
