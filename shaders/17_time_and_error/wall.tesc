#version 410 core
// The levels of the edges of a displaced cell: the lowest that keep the budget. An edge is a whole number of texels or
// half texels long. Both its neighbours cut it in the same places.

#include "common/unfinished.glsl"
#include "17_time_and_error/task.glsl"

layout(vertices = 4) out;

in vec2 v_corner[];
out vec2 c_corner[];
patch out float c_unfinished;

uniform mat4 u_clip_from_world;
uniform vec4 u_clip_along;   // a metre along the normal in clip space
uniform vec2 u_size;         // of the picture, pixels
uniform float u_budget;      // pixels
uniform float u_scale;       // of the relief, metres
uniform float u_shares[2];   // of the budget: for thinning the relief; for the error of a method
uniform vec2 u_range;        // the lowest and the highest height
uniform float u_errors[12];  // of squares of 1, 2, 4, ... texels of the height map
uniform int u_levels;
uniform float u_texels;      // of the height map, a metre
uniform vec3 u_eye;
uniform float u_reach;       // distance beyond which cells are coarser than the budget asks, metres

float level_of(vec2 a, vec2 b) {
    vec4 from = u_clip_from_world * vec4(a, 0.0, 1.0), to = u_clip_from_world * vec4(b, 0.0, 1.0);
    if (max(from.w, to.w) <= 0.0) return 1.0;
    float level = 64.0;
    if (min(from.w, to.w) > 0.0) {
        float pixels = max(pixels_per_metre(from, u_clip_along, u_size), pixels_per_metre(to, u_clip_along, u_size));
        float tolerance = tolerated(u_budget, pixels, u_scale);
        vec2 left = thinned(u_range.x, u_range.y, u_shares[0] * tolerance);
        if (left.x >= left.y) return 1.0;
        float side = exp2(floor(coarsest_level(u_errors, u_levels, u_shares[1] * tolerance))) / u_texels;
        level = exp2(ceil(log2(clamp(distance(a, b) / side, 1.0, 64.0))));
    }
    // Limits the number of triangles of the picture. The level stays a power of two, so vertices stay on the lattice.
    float away = distance(vec3(0.5 * (a + b), 0.0), u_eye);
    return u_reach > away ? level : min(level, exp2(floor(log2(max(64.0 * u_reach / away, 1.0)))));
}

void main() {
    c_corner[gl_InvocationID] = v_corner[gl_InvocationID];
    if (gl_InvocationID != 0) return;
    // Outer level 0 belongs to u = 0, the edge from corner 3 to 0. The edges from 0 to 1, 1 to 2 and 2 to 3 follow.
    float finest = 1.0;
    for (int i = 0; i < 4; ++i) {
        gl_TessLevelOuter[i] = level_of(v_corner[(i + 3) % 4], v_corner[i]);
        finest = max(finest, gl_TessLevelOuter[i]);
    }
    gl_TessLevelInner[0] = gl_TessLevelInner[1] = finest;
    c_unfinished = float(is_unfinished);
}
