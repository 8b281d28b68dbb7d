#version 410 core
// A ball that intersects a relief, which shows the relief's depth.

#include "common/light.glsl"
#include "common/srgb.glsl"

in vec3 v_position;
in vec3 v_normal;

uniform vec3 u_eye;
uniform vec3 u_to_light;
uniform float u_nothing;  // +infinity, the value of a probe without a surface

layout(location = 0) out vec4 o_color;

void main() {
#if defined PROBE_depth
    o_color = vec4(distance(u_eye, v_position), 0.0, 0.0, 0.0);
#elif defined PROBE_uv || defined PROBE_steps || defined PROBE_shadow || defined PROBE_ray || defined PROBE_guess
    o_color = vec4(u_nothing);
#else
    vec3 normal = normalize(v_normal), albedo = vec3(0.32, 0.07, 0.03);
    vec3 light = albedo * mix(vec3(0.1, 0.09, 0.08), vec3(0.25, 0.28, 0.34), 0.5 + 0.5 * normal.y);
    light += vec3(1.35, 1.22, 1.02) * blinn_phong(albedo, 0.08, 60.0, normal, u_to_light, normalize(u_eye - v_position));
    o_color = vec4(srgb_from_linear(light), 1.0);
#endif
}
