#version 410 core
// Stars, the sun, and the air in front of them.

#include "09_planet/air.glsl"
#include "common/srgb.glsl"

uniform mat3 u_world_from_view;
uniform vec2 u_tangents;  // of half the field of view, along x and y
uniform vec4 u_window;    // lower left corner and size, pixels
uniform vec3 u_eye;       // radii

layout(location = 0) out vec4 o_color;

float chance(vec3 cell) { return fract(sin(dot(cell, vec3(12.9898, 78.233, 37.719))) * 43758.5453); }

void main() {
    vec2 clip = 2.0 * (gl_FragCoord.xy - u_window.xy) / u_window.zw - 1.0;
    vec3 along = normalize(u_world_from_view * vec3(clip * u_tangents, -1.0));
    float opacity;
    vec3 light = air_light(u_eye, along, 1e9, 5, opacity);
    vec3 grid = along * 70.0, cell = floor(grid), off = fract(grid) - 0.5;
    float star = chance(cell);
    if (star > 0.965) {
        vec3 at = 0.6 * (vec3(chance(cell + 1.3), chance(cell + 2.7), chance(cell + 4.1)) - 0.5);
        float bright = smoothstep(0.11, 0.0, length(off - at)) * (star - 0.965) * 28.0;
        light += bright * (1.0 - opacity) * mix(vec3(0.7, 0.8, 1.0), vec3(1.0, 0.85, 0.7), chance(cell + 9.0));
    }
    float away = length(along - u_to_sun);
    float b = dot(u_eye, along);
    bool is_hidden = b < 0.0 && dot(u_eye, u_eye) - b * b < 1.0 && dot(u_eye, u_eye) > 1.0;
    if (!is_hidden) {
        vec3 sun = vec3(1.0, 0.86, 0.68);
        light += sun * (smoothstep(0.030, 0.024, away) * 6.0 + 0.35 * exp(-away * 14.0) + 0.10 * exp(-away * 4.0)) *
                 exp(-opacity * 1.6);
    }
    o_color = vec4(srgb_from_linear(exposed(light)), 1.0);
}
