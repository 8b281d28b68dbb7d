#version 410 core
// The vertices that the tessellator makes, displaced by the part of the relief that is left at their distance.

#include "common/unfinished.glsl"
#include "14_adaptive_displacement/task.glsl"
#include "common/patch_vertex.glsl"

patch in int c_patch;
patch in float c_level;
patch in int c_verdict;
patch in float c_unfinished;

uniform mat4 u_clip_from_model;
uniform vec3 u_eye;
uniform vec2 u_fade;    // its begin and end, metres from the eye
uniform float u_scale;  // of the relief, metres
uniform sampler2D s_heights;

out vec3 v_position;
out vec3 v_normal;
out vec4 v_tangent;
out vec2 v_uv;
out vec3 v_place;  // xy on the patch, z the patch's number
out float v_left;  // share of the displacement
flat out float v_level;
flat out int v_verdict;
out float v_unfinished;

void main() {
    PatchVertex base = patch_vertex();
#ifdef FADE
    v_left = remaining(distance(base.position, u_eye), u_fade.x, u_fade.y);
#else
    v_left = 1.0;
#endif
    float mip = 0.0;
#ifdef MIP_OF_PATCH
    // The neighbour has another level, so it reads another height at a shared vertex: cracks open.
    mip = max(log2(base.spacing.y) + log2(float(textureSize(s_heights, 0).x)) - log2(c_level), 0.0);
#endif
    float depth = u_scale * v_left * (1.0 - textureLod(s_heights, base.height_uv, mip).r);
    v_position = base.position - depth * normalize(base.direction);
    v_normal = base.normal;
    v_tangent = base.tangent;
    v_uv = base.uv;
    v_place = vec3(gl_TessCoord.xy, c_patch);
    v_level = c_level;
    v_verdict = c_verdict;
    v_unfinished = max(c_unfinished, float(is_unfinished));
    gl_Position = u_clip_from_model * vec4(v_position, 1.0);
}
