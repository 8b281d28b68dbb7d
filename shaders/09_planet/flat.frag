#version 410 core
// A patch spread out flat: its map, or the results of tasks at each place.

#include "09_planet/air.glsl"
#include "09_planet/grid.glsl"
#ifdef BUMPS
#include "09_planet/bumps.glsl"
#endif
#include "09_planet/ground.glsl"
#include "09_planet/heights.glsl"
#include "09_planet/map.glsl"
#include "common/srgb.glsl"

uniform vec4 u_window;  // of the patch: lower left corner and size, pixels
uniform mat3 u_face;
uniform vec4 u_patch_on_face;  // s and t of its lower left corner, then of its upper right one
uniform ivec2 u_patch;
uniform int u_level;

layout(location = 0) out vec4 o_color;

void main() {
    vec2 local = (gl_FragCoord.xy - u_window.xy) / u_window.zw;
    vec2 st = mix(u_patch_on_face.xy, u_patch_on_face.zw, local);
#if defined PROBE_direction
    o_color = probed(vec4(grid_direction(u_face, st), 0.0));
#elif defined PROBE_stretch
    vec3 u, v;
    grid_tangents(u_face, st, u, v);
    #ifdef LAT_LONG
    const float mean = radians(180.0) / 2.0;
#else
    const float mean = radians(180.0) / 6.0;
#endif
    o_color = probed(vec4(length(cross(u, v)) / mean, 0.0, 0.0, 0.0));
#elif defined PROBE_corner
    vec3 u, v;
    grid_tangents(u_face, st, u, v);
    o_color = probed(vec4(degrees(atan(length(cross(u, v)), dot(u, v))), 0.0, 0.0, 0.0));
#elif defined PROBE_gradient || defined PROBE_formula
    vec3 r = grid_direction(u_face, st), u, v;
    grid_tangents(u_face, st, u, v);
    const float e = 1.0 / 2048.0;
    vec4 h;
    for (int i = 0; i < 4; ++i) {
        vec2 off = i < 2 ? vec2(e, 0.0) : vec2(0.0, e);
        h[i] = height_of_elevation(elevation(grid_direction(u_face, st + (i % 2 == 0 ? off : -off))));
    }
    vec3 grad = gradient(u, v, vec2(h.x - h.y, h.z - h.w) / (2.0 * e));
#ifdef PROBE_gradient
    o_color = probed(vec4(grad, 0.0));
#else
    o_color = probed(vec4(planet_normal(r, height_of_elevation(elevation(r)), grad), 0.0));
#endif
#elif defined PROBE_texel
    ivec2 texel = ivec2(local * float(u_texels + 2));
    o_color = probed(vec4(gutter_place(texel, u_patch, u_level, u_texels), 0.0, 0.0));
#elif defined PROBE_normal
    vec4 texel = map_at(local);
    if (texel.w < -8.0) is_unfinished = true;
    o_color = probed(vec4(texel.xyz, 0.0));
#elif defined PROBE_slope
    vec4 texel = map_mean(local);
    if (texel.w < -8.0) is_unfinished = true;
    o_color = probed(vec4(texel.xy, 0.0, 0.0));
#else
    vec4 texel = map_at(local);
    if (texel.w < -8.0) is_unfinished = true;
    vec3 r = grid_direction(u_face, st), albedo;
    float gloss;
    vec3 normal = texel.xyz;
    ground(texel.w, r, normal, r, albedo, gloss);
#ifdef BUMPS
    normal = bumped(normal, u_face, st);
#endif
    // Each face has its own light, from the upper left.
    vec3 to_light = normalize(u_face * vec3(-0.8, 0.6, 0.55));
    vec3 light = albedo * (0.35 + 2.0 * max(dot(normal, to_light), 0.0));
    o_color = finished(vec4(srgb_from_linear(exposed(light)), 1.0), gl_FragCoord.xy);
#endif
}
