#version 410 core
// The instances of a skin in its pose.

#define VERTEX_STAGE
#include "18_moving_frames/passed.glsl"
#include "18_moving_frames/skin.glsl"
#include "common/unfinished.glsl"
#include "18_moving_frames/task.glsl"

layout(location = 0) in vec3 a_position;
layout(location = 3) in vec2 a_uv;
layout(location = 4) in uvec4 a_bones;
layout(location = 5) in vec4 a_weights;
layout(location = 6) in vec4 a_world_x;  // rows of world_from_model
layout(location = 7) in vec4 a_world_y;
layout(location = 8) in vec4 a_world_z;
layout(location = 9) in vec3 a_texture_u;  // rows of the texture's transform
layout(location = 10) in vec3 a_texture_v;
layout(location = 11) in int a_material;

uniform mat4 u_clip_from_world;

out vec2 v_uv;
out vec3 v_world;
flat out mat3 v_world_from_model;
flat out vec3 v_origin;
flat out mat3 v_texture;

//(posed
vec3 posed(vec3 rest) {
#if defined RIGID
    return rest;
#elif defined DUAL
    mat2x4 bones[4];
    for (int i = 0; i < 4; ++i) bones[i] = motion_of(int(a_bones[i]));
    mat2x4 motion = blended_motion(a_weights, bones);
    return moved_by(motion, motion, rest);
#else
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 4; ++i) sum += a_weights[i] * (u_bones[a_bones[i]] * vec4(rest, 1.0)).xyz;
    return sum / dot(a_weights, vec4(1.0));
#endif
}
//)

void main() {
    v_world_from_model = transpose(mat3(a_world_x.xyz, a_world_y.xyz, a_world_z.xyz));
    vec3 rest = a_position;
    v_uv = a_uv;
    // Mirroring flips the winding of triangles. But the mirror image of a body of revolution is the body itself, so a
    // mirrored body takes the vertices of the other side. So its triangles face outwards, and back faces can be culled.
    if (determinant(v_world_from_model) < 0.0) {
        rest.z = -rest.z;
        v_uv.x = 1.0 - v_uv.x;
    }
    v_origin = vec3(a_world_x.w, a_world_y.w, a_world_z.w);
    v_world = v_world_from_model * posed(rest) + v_origin;
    v_texture = transpose(mat3(a_texture_u, a_texture_v, vec3(0.0, 0.0, 1.0)));
    pass_material(a_material);
#ifdef UNROLLED
    gl_Position = vec4(2.0 * v_uv - 1.0, 0.0, 1.0);
#else
    gl_Position = u_clip_from_world * vec4(v_world, 1.0);
#endif
}
