// One texel of the brick wall: first its relief, then its colour.
#pragma once

#include "assets/bricks_wall.h"

namespace relief::bricks {

struct Texel {
    float height;
    float mortar;        ///< 0 brick, 1 mortar
    float outside;       ///< distance beyond the foot of the nearest brick, negative on the brick
    float fresh, pit;    ///< from 0 to 1: broken open, and in a pit
    float sand;          ///< how bright a grain of sand makes the mortar, about 1
    const Brick* brick;  ///< the nearest one; null in the middle of the joints
};
Texel relief_at(glm::vec2 p, const Wall& wall);

/// `hollow` is how much lower the texel lies than what is around it, in texels, near by and farther out.
glm::vec3 light_at(glm::vec2 p, const Texel& texel, glm::vec2 hollow);

}  // namespace relief::bricks
