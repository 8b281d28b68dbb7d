#version 410 core
// A height map from a picture. Alpha is 0 if the task is not written yet.

#include "common/unfinished.glsl"
#include "03_height_to_normal/task.glsl"

uniform sampler2D s_picture;  // stored values (sRGB), not decoded to light

layout(location = 0) out vec4 o_height;

void main() {
    float height = height_of_color(texelFetch(s_picture, ivec2(gl_FragCoord.xy), 0).rgb);
    o_height = vec4(height, 0.0, 0.0, is_unfinished ? 0.0 : 1.0);
}
