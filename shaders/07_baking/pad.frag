#version 410 core
// One step of padding: fills texels that no triangle covers from their neighbours.

#include "common/unfinished.glsl"
#include "07_baking/task.glsl"

uniform sampler2D s_texels;
uniform int u_size;

layout(location = 0) out vec4 o_texel;

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    vec4 around[8];
    int count = 0;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            if (x == 0 && y == 0) continue;
            ivec2 there = here + ivec2(x, y);
            bool is_inside = all(greaterThanEqual(there, ivec2(0))) && all(lessThan(there, ivec2(u_size)));
            around[count++] = is_inside ? texelFetch(s_texels, there, 0) : vec4(-1.0, -1.0, -1.0, 0.0);
        }
    vec4 texel = texelFetch(s_texels, here, 0);
    o_texel = padded(texel, around);
    if (is_unfinished) o_texel.w = 2.0;
}
