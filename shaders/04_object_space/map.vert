#version 410 core
// One triangle over a small window.

out vec2 v_uv;

void main() {
    vec2 clip = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    v_uv = 0.5 * clip + 0.5;
    gl_Position = vec4(clip, 0.0, 1.0);
}
