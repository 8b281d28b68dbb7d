#include "assets/bricks.h"

#include "assets/bricks_texel.h"

namespace relief {

SurfaceMaps make_bricks(int size) {
    const bricks::Wall wall = bricks::lay_wall();
    return make_surface(
        size, bricks_depth_in_texels, [&](glm::vec2 p) { return bricks::relief_at(p, wall); }, bricks::light_at);
}

}  // namespace relief
