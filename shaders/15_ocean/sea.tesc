#version 410 core
// The levels of a patch, from the longest segments that its rings allow. They depend on the radius only, so neighbours
// agree. Patches outside of the picture are culled.

layout(vertices = 4) out;

in vec3 v_polar[];
out vec3 c_polar[];

uniform mat4 u_clip_from_eye;
uniform float u_eye_height;
uniform float u_highest;  // upper bound of the sea's height, metres; 0 for a flat sea

bool is_outside() {
    bvec3 low = bvec3(true);
    bvec2 high = bvec2(true);
    for (int i = 0; i < 8; ++i) {
        // The arc between two corners lies outside of its chord.
        vec3 polar = v_polar[i % 4];
        float radius = polar.x * (i % 4 > 1 ? 1.02 : 1.0), height = i < 4 ? -u_highest : u_highest;
        vec4 clip = u_clip_from_eye * vec4(radius * sin(polar.y), height - u_eye_height, radius * cos(polar.y), 1.0);
        low = bvec3(low.x && clip.x < -clip.w, low.y && clip.y < -clip.w, low.z && clip.w < 0.0);
        high = bvec2(high.x && clip.x > clip.w, high.y && clip.y > clip.w);
    }
    return any(low) || any(high);
}

void main() {
    c_polar[gl_InvocationID] = v_polar[gl_InvocationID];
    if (gl_InvocationID != 0) return;
    vec3 inner = v_polar[0], outer = v_polar[3];
    float angle = v_polar[1].y - inner.y;
    vec3 levels = vec3(outer.x - inner.x, inner.x * angle, outer.x * angle) /
                  exp2(vec3(min(inner.z, outer.z), inner.z, outer.z));
    levels = is_outside() ? vec3(0.0) : clamp(levels, 1.0, 64.0);
    gl_TessLevelOuter[0] = levels.x;  // u = 0
    gl_TessLevelOuter[1] = levels.y;  // v = 0
    gl_TessLevelOuter[2] = levels.x;
    gl_TessLevelOuter[3] = levels.z;
    gl_TessLevelInner[0] = max(levels.y, levels.z);
    gl_TessLevelInner[1] = levels.x;
}
