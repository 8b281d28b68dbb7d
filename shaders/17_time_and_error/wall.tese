#version 410 core
// The wall, displaced by its thinned relief.

#include "common/unfinished.glsl"
#include "17_time_and_error/task.glsl"

layout(quads, equal_spacing, ccw) in;

in vec2 c_corner[];
patch in float c_unfinished;

uniform mat4 u_clip_from_world;
uniform vec4 u_clip_along;
uniform vec2 u_size;
uniform float u_budget;
uniform float u_scale;
uniform float u_shares[2];
uniform vec2 u_range;
uniform sampler2D s_heights;

out vec2 v_place;
out float v_height;
out float v_unfinished;

void main() {
    // Neighbours compute a vertex on their common edge from different corners. Rounding to 1/4096 m makes them agree.
    vec2 lower = mix(c_corner[0], c_corner[1], gl_TessCoord.x), upper = mix(c_corner[3], c_corner[2], gl_TessCoord.x);
    vec2 place = mix(lower, upper, gl_TessCoord.y);
    v_place = round(place * 4096.0) / 4096.0;
    vec4 clip = u_clip_from_world * vec4(v_place, 0.0, 1.0);
    float pixels = pixels_per_metre(clip, u_clip_along, u_size);
    vec2 left = thinned(u_range.x, u_range.y, clip.w > 0.0 ? u_shares[0] * tolerated(u_budget, pixels, u_scale) : 0.0);
    v_height = clamp(textureLod(s_heights, v_place, 0.0).r, left.x, left.y);
    v_unfinished = max(c_unfinished, float(is_unfinished));
    gl_Position = clip - u_clip_along * (u_scale * (1.0 - v_height));
}
