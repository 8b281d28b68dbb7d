// Lab 01, yours: from what a normal map stores to a direction in the world.

#include "common/unfinished.glsl"

// TASK 1.1 (2 points): the sampler gives each component in [0, 1], where 0 stands for -1 and 1 for 1. Undo that. Then let
// `strength` make the bumps higher or lower: it multiplies x and y, and 0 is flat. Of any length: 1.2 makes it unit.
//(texel
vec3 direction_of_texel(vec3 stored, float strength) {
    //[solution
    vec3 direction = stored * 2.0 - 1.0;
    return vec3(direction.xy * strength, direction.z);
    //]starter
    //| return unfinished(vec3(0.0, 0.0, 1.0));
    //]
}
//)

// TASK 1.2 (3 points): x counts along the tangent, y along the bitangent, z along the normal. The three are directions in
// the world; where is `direction` in the world? Make it unit: light is a cosine.
//(world
vec3 direction_in_world(vec3 direction, vec3 tangent, vec3 bitangent, vec3 normal) {
    //[solution
    return normalize(direction.x * tangent + direction.y * bitangent + direction.z * normal);
    //]starter
    //| return unfinished(normal);
    //]
}
//)
