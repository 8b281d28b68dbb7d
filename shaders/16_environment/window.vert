#version 410 core
// One triangle over the whole target.

out vec2 v_window;

void main() {
    v_window = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    gl_Position = vec4(v_window, 1.0, 1.0);
}
