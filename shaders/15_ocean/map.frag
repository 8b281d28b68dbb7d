#version 410 core
// A map of waves over the window: a normal map in its colours, or HEIGHTS as grey.

in vec2 v_clip;

uniform sampler2D s_map;
uniform float u_level;  // the mip level, if ONE_LEVEL

layout(location = 0) out vec4 o_color;

void main() {
    vec2 uv = 0.5 + 0.5 * v_clip;
#ifdef ONE_LEVEL
    vec3 texel = textureLod(s_map, uv, u_level).xyz;
#else
    vec3 texel = texture(s_map, uv).xyz;
#endif
#ifdef HEIGHTS
    texel = vec3(0.5 + 0.6 * texel.z);  // nearly all waves are within 0.8 metres
#endif
    o_color = vec4(texel, 1.0);
}
