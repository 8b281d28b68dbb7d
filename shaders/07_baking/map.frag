#version 410 core
// The stored map over a square of the picture, with padding and misses tinted; or its probes.

#include "common/unfinished.glsl"
#include "07_baking/task.glsl"

uniform sampler2D s_map;
uniform sampler2D s_texels;  // baked normals, before padding
uniform sampler2D s_hits;
uniform vec4 u_window;  // lower left corner and size, pixels
uniform float u_level;

layout(location = 0) out vec4 o_color;

void main() {
    vec2 uv = (gl_FragCoord.xy - u_window.xy) / u_window.zw;
    ivec2 size = textureSize(s_texels, 0);
    ivec2 texel = clamp(ivec2(uv * vec2(size) + 0.001), ivec2(0), size - 1);  // on a border, the upper or right one
    bool is_covered = texelFetch(s_texels, texel, 0).w > 0.0;
    vec4 hit = texelFetch(s_hits, texel, 0);
    int level = int(u_level);
    ivec2 level_size = textureSize(s_map, level);
    vec4 stored = texelFetch(s_map, clamp(ivec2(uv * vec2(level_size) + 0.001), ivec2(0), level_size - 1), level);
    if (stored.a < 0.9) is_unfinished = true;
#if defined PROBE_stored
    if (!is_covered) discard;
    o_color = probed(vec4(2.0 * stored.xyz - 1.0, 0.0));
#elif defined PROBE_hit
    is_unfinished = hit.z > 0.0;
    if (!is_covered || (hit.y == 0.0 && !is_unfinished)) discard;
    o_color = probed(vec4(hit.x, 0.0, 0.0, 0.0));
#else
    vec3 color = stored.xyz;
    if (!is_covered && level == 0) color *= vec3(0.72, 0.66, 0.60);
    if (is_covered && hit.y == 0.0) color = vec3(0.80, 0.16, 0.10);
    if (is_covered && hit.y > 1.5) color = mix(color, vec3(0.62, 0.20, 0.85), 0.8);
    o_color = finished(vec4(color, 1.0), gl_FragCoord.xy);
#endif
}
