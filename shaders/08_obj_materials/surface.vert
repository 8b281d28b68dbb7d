#version 410 core
// A surface of an OBJ file, in world coordinates.

#include "08_obj_materials/features.glsl"

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;

uniform mat4 u_clip_from_world;

out vec3 v_place;
out vec3 v_normal;
#if (FEATURES & (COLOR_MAP | HIGHLIGHT_MAP | NORMAL_MAP | HEIGHT_MAP | MASK_MAP)) != 0
layout(location = 3) in vec2 a_uv;
uniform float u_tiling;
out vec2 v_uv;
#endif
#if (FEATURES & (NORMAL_MAP | HEIGHT_MAP)) != 0
layout(location = 2) in vec4 a_tangent;
out vec4 v_tangent;
#endif

void main() {
    v_place = a_position;
    v_normal = a_normal;
#if (FEATURES & (COLOR_MAP | HIGHLIGHT_MAP | NORMAL_MAP | HEIGHT_MAP | MASK_MAP)) != 0
    v_uv = u_tiling * a_uv;
#endif
#if (FEATURES & (NORMAL_MAP | HEIGHT_MAP)) != 0
    v_tangent = a_tangent;
#endif
    gl_Position = u_clip_from_world * vec4(a_position, 1.0);
}
