#version 410 core
// The input of occlusion: the surface's normal in the camera's space, and its distance ahead.

in vec3 v_normal;
in vec4 v_clip;

uniform mat3 u_view_from_world;

layout(location = 0) out vec4 o_surface;

void main() {
    o_surface = vec4(u_view_from_world * normalize(v_normal), v_clip.w);
}
