// Lab 01, your tasks: from a texel of a normal map to a direction in the world.

#include "common/unfinished.glsl"

// TASK 1.1 (2 points): the sampler gives each component in [0, 1], where 0 stands for -1 and 1 for 1. Undo that. Then
// apply `strength`: it multiplies x and y, so that bumps become higher or lower; 0 is flat. The result may have any
// length: 1.2 normalises it.
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

// TASK 1.2 (3 points): transform `direction` to the world: x goes along the tangent, y along the bitangent, z along
// the normal, and these three are directions in the world. Normalise the result: light is a cosine.
//(world
vec3 direction_in_world(vec3 direction, vec3 tangent, vec3 bitangent, vec3 normal) {
    //[solution
    return normalize(direction.x * tangent + direction.y * bitangent + direction.z * normal);
    //]starter
    //| return unfinished(normal);
    //]
}
//)
