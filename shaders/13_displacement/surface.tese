#version 410 core
// The vertices that the tessellator makes, displaced by the height map.

#include "common/unfinished.glsl"
#include "13_displacement/task.glsl"
#include "common/patch_vertex.glsl"

patch in int c_patch;

uniform mat4 u_clip_from_model;
uniform float u_scale;  // of the relief, metres
uniform float u_level;  // along the edges
uniform sampler2D s_heights;

// Outputs that no permutation reads cost nothing.
out vec3 v_position;
out vec3 v_normal;
out vec4 v_tangent;
out vec2 v_uv;
out vec3 v_base;       // undisplaced
out vec3 v_direction;  // of the relief; not normalised
out vec3 v_place;      // xy on the patch, z the patch's number
out float v_mip;
out float v_unfinished;

void main() {
    //(evaluate
    PatchVertex base = patch_vertex();
    v_mip = 0.0;
#ifdef MIP
    v_mip = height_level(base.spacing.y * float(textureSize(s_heights, 0).x), u_level);
#endif
    v_position = displaced(base.position, base.direction, read_height(s_heights, base.height_uv, v_mip), u_scale);
    //)
    v_normal = base.normal;
    v_tangent = base.tangent;
    v_uv = base.uv;
    v_base = base.position;
    v_direction = base.direction;
    v_place = vec3(gl_TessCoord.xy, c_patch);
    v_unfinished = float(is_unfinished);
    gl_Position = u_clip_from_model * vec4(v_position, 1.0);
}
