#version 410 core
// The normals of a patch's texels and of its gutter, from slopes of the heights and their gradient. w is the elevation,
// or -9 where a task is unfinished.

#include "09_planet/grid.glsl"

uniform sampler2D s_heights;
uniform mat3 u_face;
uniform ivec2 u_patch;
uniform int u_level;
uniform int u_texels;
uniform ivec2 u_corner;          // of the patch's tile in the map, pixels
uniform ivec2 u_heights_corner;  // of the patch's tile in the heights, pixels

layout(location = 0) out vec4 o_normal;

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy) - u_corner;
#ifdef NO_GUTTER
    texel = clamp(texel, ivec2(1), ivec2(u_texels));
#endif
    ivec2 middle = u_heights_corner + texel + 1;
    float h[9];
    for (int i = 0; i < 9; ++i) h[i] = texelFetch(s_heights, middle + ivec2(i % 3 - 1, i / 3 - 1), 0).x;
    vec4 here = texelFetch(s_heights, middle, 0);
    if (here.w == 0.0) is_unfinished = true;
    vec2 slope = slopes(h, u_texels, u_level);
#if defined STRENGTH_PLUS_1
    // Correct at level 0 only. At levels 1, 2 and 3 slopes are 3/4, 5/8 and 9/16 of the correct ones.
    slope *= 0.5 * (1.0 + exp2(float(u_level))) / exp2(float(u_level));
#elif defined STRENGTH_NONE
    slope /= exp2(float(u_level));
#endif
#ifdef PROBE_slope
    o_normal = vec4(slope, 0.0, here.y);
#else
    vec2 st = gutter_place(texel, u_patch, u_level, u_texels);
    vec3 r = grid_direction(u_face, st), u, v;
    grid_tangents(u_face, st, u, v);
#if defined RIGHT_ANGLED
    vec3 normal = normalize((1.0 + here.x) * r - slope.x * u / dot(u, u) - slope.y * v / dot(v, v));
#elif defined B_BY_CROSS
    vec3 t = normalize(u), b = cross(r, t);
    vec3 normal = normalize((1.0 + here.x) * r - slope.x / length(u) * t - slope.y / length(v) * b);
#elif defined ONE_SCALE
    // One scale of slopes for all texels, as on a flat map.
    vec3 t = normalize(u), b = cross(r, t);
#ifdef LAT_LONG
    const float angle_of_unit = radians(90.0);
#else
    const float angle_of_unit = radians(45.0);
#endif
    vec3 normal = normalize(r - (slope.x * t + slope.y * b) / angle_of_unit);
#else
    vec3 normal = planet_normal(r, here.x, gradient(u, v, slope));
#endif
    o_normal = vec4(normal, here.y);
#endif
    if (is_unfinished) o_normal = vec4(0.0, 0.0, 1.0, -9.0);
}
