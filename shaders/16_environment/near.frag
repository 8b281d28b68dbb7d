#version 410 core
// What occlusion looks at: the normal of the surface in the camera's space, and how far ahead it lies.

#ifdef DISPLACED
#include "16_environment/ground.glsl"
#endif

in vec3 v_position;
in vec3 v_normal;
in vec4 v_clip;

uniform mat3 u_view_from_world;

layout(location = 0) out vec4 o_surface;

void main() {
    vec3 normal = normalize(v_normal);
#ifdef DISPLACED
    vec3 ground = floor_at(ground_at(v_position.xz));
    normal = normalize(vec3(-ground.y, 1.0, -ground.z));
#endif
    o_surface = vec4(u_view_from_world * normal, v_clip.w);
}
