#version 410 core
// The colours of a texture as they are stored: of a normal map, or of baked light.

in vec2 v_uv;

uniform sampler2D s_normals;

layout(location = 0) out vec4 o_color;

void main() { o_color = vec4(texture(s_normals, v_uv).rgb, 1.0); }
