#version 410 core
// The finished texels as a picture: maps [-1, 1] to [0, 1], black where nothing was baked. Alpha is 0 where a task is
// unfinished.

uniform sampler2D s_texels;

layout(location = 0) out vec4 o_color;

void main() {
    vec4 texel = texelFetch(s_texels, ivec2(gl_FragCoord.xy), 0);
    o_color = vec4(0.5 + 0.5 * texel.xyz, texel.w > 1.5 ? 0.0 : 1.0);
}
