#version 410 core
// v < 0: a plain rectangle. v > 1: a heat scale along u. Otherwise a letter.

#include "common/heat.glsl"

in vec2 v_uv;
in vec4 v_color;

uniform sampler2D s_letters;

layout(location = 0) out vec4 o_color;

void main() {
    if (v_uv.y < -0.5)
        o_color = v_color;
    else if (v_uv.y > 1.5)
        o_color = vec4(heat(v_uv.x), 1.0);
    else
        o_color = vec4(v_color.rgb, v_color.a * texture(s_letters, v_uv).r);
}
