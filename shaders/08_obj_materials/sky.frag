#version 410 core
// The sky at dusk or by day, with the trees at the end of the garden. Its light depends on height and the sun.

#include "common/srgb.glsl"

in vec2 v_clip;

uniform vec3 u_forward;
uniform vec3 u_right;
uniform vec3 u_up;
uniform vec3 u_to_sun;
uniform float u_day;  // 0 at dusk, 1 by day

layout(location = 0) out vec4 o_color;

/// Returns the height of the trees in a direction, as the sine of the angle.
float trees(float angle) {
    return 0.020 + 0.010 * sin(5.0 * angle + 1.0) + 0.006 * sin(17.0 * angle) + 0.004 * sin(41.0 * angle + 2.0) +
           0.0025 * sin(113.0 * angle) + 0.0015 * sin(293.0 * angle);
}

vec3 sky(vec3 direction) {
    float height = max(direction.y, 0.0), to_sun = dot(direction, u_to_sun);
    if (direction.y < trees(atan(direction.x, -direction.z)))
        return mix(vec3(0.006, 0.008, 0.011), vec3(0.05, 0.08, 0.03), u_day);
    vec3 dusk = mix(vec3(0.34, 0.13, 0.075), vec3(0.018, 0.034, 0.13), 1.0 - exp(-9.0 * height));
    dusk += vec3(0.75, 0.25, 0.05) * exp(-5.0 * (1.0 - to_sun)) * exp(-6.0 * height);
    return mix(dusk, mix(vec3(0.62, 0.74, 0.9), vec3(0.16, 0.33, 0.72), 1.0 - exp(-3.0 * height)), u_day);
}

void main() {
    vec3 light = sky(normalize(u_forward + v_clip.x * u_right + v_clip.y * u_up));
#ifdef STORED
    light = srgb_from_linear(light);
#endif
    o_color = vec4(light, 1.0);
}
