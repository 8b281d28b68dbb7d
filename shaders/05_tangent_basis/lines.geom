#version 410 core
// Draws tangents red, bitangents green and normals blue, two pixels wide. Lines across the view are `u_length` pixels
// long.

layout(points) in;
layout(triangle_strip, max_vertices = 12) out;

in Frame {
    vec3 normal;
    vec4 tangent;
} v_frame[];

uniform mat4 u_clip_from_world;
uniform vec2 u_size;           // of the window, pixels
uniform float u_length;
uniform float u_focal_pixels;  // pixels per metre, at a distance of one metre

flat out vec3 v_color;

void draw_line(vec3 from, vec3 direction, vec3 color) {
    vec4 a = u_clip_from_world * vec4(from, 1.0);
    vec4 b = u_clip_from_world * vec4(from + direction * u_length * a.w / u_focal_pixels, 1.0);
    if (a.w <= 0.0 || b.w <= 0.0) return;
    vec2 along = (b.xy / b.w - a.xy / a.w) * u_size;
    float pixels = length(along);
    if (pixels < 1e-3) return;
    vec2 across = vec2(-along.y, along.x) / pixels * 2.0 / u_size;
    a.z -= 2e-4 * a.w;
    b.z -= 2e-4 * b.w;
    v_color = color;
    gl_Position = a + vec4(across * a.w, 0.0, 0.0);
    EmitVertex();
    gl_Position = a - vec4(across * a.w, 0.0, 0.0);
    EmitVertex();
    gl_Position = b + vec4(across * b.w, 0.0, 0.0);
    EmitVertex();
    gl_Position = b - vec4(across * b.w, 0.0, 0.0);
    EmitVertex();
    EndPrimitive();
}

void main() {
    vec3 from = gl_in[0].gl_Position.xyz, normal = v_frame[0].normal;
    vec4 tangent = v_frame[0].tangent;
    draw_line(from, tangent.xyz, vec3(0.95, 0.25, 0.22));
    draw_line(from, tangent.w * cross(normal, tangent.xyz), vec3(0.35, 0.85, 0.30));
    draw_line(from, normal, vec3(0.35, 0.55, 1.0));
}
