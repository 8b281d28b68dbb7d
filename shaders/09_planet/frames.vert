#version 410 core
// The frames of a patch as lines two pixels wide. The grid's tangents are red along s and green along t, and the map's
// normal is blue. Each place has eighteen vertices.

#include "09_planet/grid.glsl"
#include "09_planet/heights.glsl"
#include "09_planet/map.glsl"

uniform mat3 u_face;
uniform vec4 u_patch_on_face;  // s and t of its lower left corner, then of its upper right one
uniform vec3 u_eye;            // radii
uniform mat3 u_view_from_world;
uniform vec2 u_zoom;
uniform vec2 u_size;           // of the picture, pixels
uniform float u_length;        // of a line, radii
uniform float u_near;          // radii
uniform int u_side;            // places along a patch's side

flat out vec3 v_color;
out float v_away;

vec4 clip_of(vec3 place) {
    vec3 seen = u_view_from_world * (place - u_eye);
    return vec4(u_zoom * seen.xy, -seen.z - 2.0 * u_near, -seen.z);
}

void main() {
    int line = gl_VertexID / 6 % 3, point = gl_VertexID / 18;
    vec2 local = (vec2(point % u_side, point / u_side) + 0.5) / float(u_side);
    vec2 st = mix(u_patch_on_face.xy, u_patch_on_face.zw, local);
    vec3 r = grid_direction(u_face, st), u, v;
    grid_tangents(u_face, st, u, v);
    vec4 texel = map_at(local);
    // Starts a little above the ground, which would hide lines along it.
    vec3 from = r * (1.0 + height_of_elevation(texel.w) + 0.12 * u_length);
    vec4 a = clip_of(from);
    vec4 b = clip_of(from + u_length * (line == 0 ? normalize(u) : line == 1 ? normalize(v) : texel.xyz));
    vec2 along = (b.xy / b.w - a.xy / a.w) * u_size;
    vec2 across = vec2(-along.y, along.x) / max(length(along), 1e-3) * 2.0 / u_size;
    const vec2 corners[6] = vec2[](vec2(0, -1), vec2(1, -1), vec2(1, 1), vec2(0, -1), vec2(1, 1), vec2(0, 1));
    vec2 corner = corners[gl_VertexID % 6];
    gl_Position = corner.x == 0.0 ? a : b;
    v_away = gl_Position.w;
    gl_Position.xy += corner.y * across * gl_Position.w;
    v_color = line == 0 ? vec3(0.95, 0.25, 0.22) : line == 1 ? vec3(0.35, 0.85, 0.30) : vec3(0.35, 0.55, 1.0);
}
