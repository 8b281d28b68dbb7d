#version 410 core
// The floor and the backdrop of framework/library/kit/studio.h. Far away both have one colour, so there is no horizon.

#include "common/srgb.glsl"

in vec2 v_clip;

uniform sampler2D s_shadow;  // share of the sky's light that is hidden from the floor
uniform vec3 u_eye;          // from the middle of the shadow, metres
uniform vec3 u_forward;
uniform vec3 u_right;
uniform vec3 u_up;
uniform float u_radius;  // of what stands on the floor, metres
uniform float u_reach;   // half the side of the shadow's map, metres
uniform float u_focus;   // see on_floor() in studio.cpp

layout(location = 0) out vec4 o_color;

const vec3 far_color = vec3(0.042, 0.045, 0.051);
const vec3 top_color = vec3(0.012, 0.0135, 0.017);
const vec3 floor_color = vec3(0.118, 0.117, 0.113);

void main() {
    vec3 ray = u_forward + v_clip.x * u_right + v_clip.y * u_up;
    vec3 light = mix(far_color, top_color, smoothstep(0.0, 0.7, normalize(ray).y));
    if (ray.y < 0.0 && u_eye.y > 0.0) {
        vec2 place = u_eye.xz - ray.xz * (u_eye.y / ray.y);  // on the floor, metres from the middle
        vec2 share = clamp(place / u_reach, -1.0, 1.0);
        vec2 texel = share * (1.0 + u_focus) / (1.0 + u_focus * abs(share));
        float near_border = max(abs(texel.x), abs(texel.y));
        float hidden = texture(s_shadow, texel * 0.5 + 0.5).r * (1.0 - smoothstep(0.8, 1.0, near_border));
        float away = dot(place, place) / (u_radius * u_radius);
        float open = 1.0 - hidden;
        // The square, since light from above counts more.
        light = mix(far_color, floor_color, 1.0 / (1.0 + 0.12 * away)) * open * open;
    }
    // One step of 8 bits, spread over pixels (Jimenez 2014), so that no band is seen.
    float noise = fract(52.9829189 * fract(dot(floor(gl_FragCoord.xy), vec2(0.06711056, 0.00583715))));
    o_color = vec4(srgb_from_linear(light) + (noise - 0.5) / 255.0, 1.0);
}
