// The stone of lab 19 under a low sun, in linear light.

uniform float u_gloss;  // brightness of a highlight

vec3 haze(vec3 direction, vec3 to_light) {
    float towards = pow(max(0.5 + 0.5 * dot(direction, to_light), 0.0), 6.0);
    return mix(vec3(0.20, 0.25, 0.32), vec3(0.34, 0.40, 0.47), smoothstep(-0.1, 0.5, direction.y)) +
           vec3(0.40, 0.24, 0.10) * towards;
}

// `height` is 0 in joints and about 1 on faces; `fine` is that of the grain, about -1 to 1.
vec3 stone_lit(float height, float fine, vec2 uv, vec3 normal, vec3 smooth_normal, vec3 to_light) {
    float face = smoothstep(0.05, 0.75, height);
    vec3 albedo = mix(vec3(0.17, 0.155, 0.14), vec3(0.46, 0.40, 0.33), face);
    albedo *= 1.0 + 0.12 * sin(6.28318531 * (uv.x + 2.0 * uv.y)) * sin(6.28318531 * (2.0 * uv.x - uv.y) + 1.0);
    albedo *= 1.0 + 0.25 * clamp(fine, -1.0, 1.0);
    vec3 sun = vec3(2.5, 2.05, 1.5) * max(dot(normal, to_light), 0.0) * smoothstep(-0.05, 0.08, dot(smooth_normal, to_light));
    vec3 sky = mix(vec3(0.16, 0.14, 0.12), vec3(0.30, 0.37, 0.48), 0.5 + 0.5 * normal.y);
    return albedo * (sun + sky * (0.45 + 0.55 * face));
}
