#version 410 core
// A height map from a picture. Alpha 0 says that the task is not written yet.

#include "03_height_to_normal/task.glsl"

uniform sampler2D s_picture;  // as stored, not as light

layout(location = 0) out vec4 o_height;

void main() {
    float height = height_of_color(texelFetch(s_picture, ivec2(gl_FragCoord.xy), 0).rgb);
    o_height = vec4(height, 0.0, 0.0, is_unfinished ? 0.0 : 1.0);
}
