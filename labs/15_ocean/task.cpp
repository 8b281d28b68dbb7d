// Lab 15, your first task: how far the waves have come. The others are in shaders/15_ocean/task.glsl.
#include "task.h"

#include "framework/core/base/unfinished.h"

namespace relief::ocean {

// TASK 15.1 (2 points): how far a map has moved, in tiles, without the whole ones: from 0 to 1, 1 excluded. A sea may
// run for years, and also backwards (`time` may be negative). A float has 24 binary digits: after a day its
// steps are half a texel, so stay in double precision until whole tiles are gone.
//(scroll
glm::dvec2 scroll(const glm::dvec2& velocity, double time) {
    //[solution
    const glm::dvec2 way = velocity * time, rest = way - glm::floor(way);
    return {rest.x < 1 ? rest.x : 0.0, rest.y < 1 ? rest.y : 0.0};  // -1e-20 minus its floor, -1, rounds to 1
    //]starter
    //| static_cast<void>(velocity), static_cast<void>(time);
    //| unfinished("15.1");
    //]
}
//)

}  // namespace relief::ocean
