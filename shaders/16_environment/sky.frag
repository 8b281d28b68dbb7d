#version 410 core
// The sky behind the court.

#include "16_environment/sky.glsl"
#include "common/srgb.glsl"

in vec2 v_clip;

uniform vec3 u_forward;
uniform vec3 u_right;  // half of the picture's width, one metre ahead
uniform vec3 u_up;

layout(location = 0) out vec4 o_color;

void main() {
    vec3 direction = normalize(u_forward + v_clip.x * u_right + v_clip.y * u_up);
    o_color = vec4(srgb_from_linear(exposed(sky_at(direction, 0.0))), 1.0);
}
