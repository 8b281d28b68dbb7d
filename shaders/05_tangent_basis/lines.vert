#version 410 core
// Draws tangents red, bitangents green and normals blue, two pixels wide. Lines across the view are `u_length` pixels
// long. Three instances a vertex of the mesh, one for each line, and four corners an instance.

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec4 a_tangent;

uniform mat4 u_clip_from_world;
uniform vec2 u_size;           // of the window, pixels
uniform float u_length;
uniform float u_focal_pixels;  // pixels per metre, at a distance of one metre

flat out vec3 v_color;

void main() {
    int line = gl_InstanceID % 3;
    vec3 bitangent = a_tangent.w * cross(a_normal, a_tangent.xyz);
    vec3 direction = line == 0 ? a_tangent.xyz : line == 1 ? bitangent : a_normal;
    v_color = line == 0 ? vec3(0.95, 0.25, 0.22) : line == 1 ? vec3(0.35, 0.85, 0.30) : vec3(0.35, 0.55, 1.0);

    vec4 a = u_clip_from_world * vec4(a_position, 1.0);
    vec4 b = u_clip_from_world * vec4(a_position + direction * u_length * a.w / u_focal_pixels, 1.0);
    vec2 along = (b.xy / b.w - a.xy / a.w) * u_size;
    float pixels = length(along);
    gl_Position = vec4(0.0, 0.0, 2.0, 1.0);  // outside of the view: draws nothing
    if (a.w <= 0.0 || b.w <= 0.0 || pixels < 1e-3) return;
    vec2 across = vec2(-along.y, along.x) / pixels * 2.0 / u_size;
    vec4 end = gl_VertexID < 2 ? a : b;
    end.z -= 2e-4 * end.w;
    gl_Position = end + vec4((gl_VertexID % 2 == 0 ? across : -across) * end.w, 0.0, 0.0);
}
