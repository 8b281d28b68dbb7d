#version 410 core
// A vertical section through the lamp's light, across the view: the share that would reach a surface at each place.

#include "common/unfinished.glsl"
#include "08_obj_materials/task.glsl"
#include "08_obj_materials/lamp.glsl"
#include "common/srgb.glsl"

uniform vec2 u_middle;  // pixels
uniform float u_pixel;  // metres
uniform vec3 u_lamp_light;

layout(location = 0) out vec4 o_color;

void main() {
    vec2 off = (gl_FragCoord.xy - u_middle) * u_pixel;
    float share = lamp_share(vec3(off, 0.0));
#ifdef PROBE_lamp
    o_color = vec4(share, 0.0, 0.0, 0.0);
#else
    // A line wherever the share is a power of 1/2.
    float halvings = -log2(max(share, 1e-9)), line = abs(fract(halvings + 0.5) - 0.5) / max(fwidth(halvings), 1e-6);
    vec3 light = vec3(0.010, 0.014, 0.028) + 0.25 * share * u_lamp_light;
    if (share > 1e-4) light += 0.12 * vec3(1.0, 0.8, 0.5) * (1.0 - smoothstep(0.4, 1.4, line));
    float middle = length(off) / u_pixel;
    light += vec3(1.0, 0.8, 0.4) * (1.0 - smoothstep(3.0, 4.5, middle));
    o_color = finished(vec4(srgb_from_linear(1.0 - exp(-1.7 * light)), 1.0), gl_FragCoord.xy);
#endif
}
