#version 410 core
// The haze behind a solid.

#include "19_layered_normals/stone.glsl"
#include "common/srgb.glsl"

in vec2 v_clip;

uniform vec3 u_forward;
uniform vec3 u_right;  // half of the picture's width, one metre ahead
uniform vec3 u_up;
uniform vec3 u_to_light;

layout(location = 0) out vec4 o_color;

void main() {
    vec3 direction = normalize(u_forward + v_clip.x * u_right + v_clip.y * u_up);
    o_color = vec4(srgb_from_linear(haze(direction, u_to_light)), 1.0);
}
