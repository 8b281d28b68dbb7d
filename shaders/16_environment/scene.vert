#version 410 core
// All surfaces of the scene: the same triangles for the picture, the sun's depth map and occlusion.

#ifdef DISPLACED
#include "16_environment/ground.glsl"
#endif

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec4 a_tangent;
layout(location = 3) in vec2 a_uv;

uniform mat4 u_clip_from_world;

out vec3 v_position;
out vec3 v_normal;
out vec3 v_tangent;
out vec2 v_uv;
out vec4 v_clip;

void main() {
    v_position = a_position;
    v_normal = a_normal;
    v_tangent = a_tangent.xyz;
    v_uv = a_uv;
#ifdef DISPLACED
    vec3 rise = floor_at(ground_at(a_position.xz));
    v_position.y += rise.x;
    v_normal = normalize(vec3(-rise.y, 1.0, -rise.z));
#endif
    v_clip = u_clip_from_world * vec4(v_position, 1.0);
    gl_Position = v_clip;
}
