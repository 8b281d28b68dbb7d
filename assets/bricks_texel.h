// One texel of the brick wall: its relief, then its colour.
#pragma once

#include "assets/bricks_wall.h"

namespace relief::bricks {

struct Texel {
    float height;
    float mortar;        ///< 0 brick, 1 mortar
    float outside;       ///< distance from the foot of the nearest brick; negative on the brick
    float fresh, pit;    ///< 0 to 1: broken open; in a pit
    float sand;          ///< brightness of a sand grain in the mortar, about 1
    const Brick* brick;  ///< the nearest brick; null in the middle of the joints
};
Texel relief_at(glm::vec2 p, const Wall& wall);

/// Returns the linear colour of a texel. `hollow` is its depth below the surrounding mean, in texels: near (x) and
/// farther out (y).
glm::vec3 light_at(glm::vec2 p, const Texel& texel, glm::vec2 hollow);

}  // namespace relief::bricks
