#version 410 core
// A needle for each texel of a part of a normal map, from the middle of the texel along its vector; then the axes T, B
// and N at the corner of the square. Four corners an instance; needles end in a point.

uniform mat4 u_clip_from_world;
uniform vec2 u_size;  // of the window, pixels
uniform vec3 u_part;  // the part of the map on the square from -1 to 1: its lower left corner and its size, in uv
uniform sampler2D s_stored;

flat out vec3 v_color;
out float v_along;  // 0 at the foot, 1 at the tip

void main() {
    ivec2 size = textureSize(s_stored, 0);
    int side = int(float(size.x) * u_part.z + 0.5), axis = gl_InstanceID - side * side;
    ivec2 within = ivec2(gl_InstanceID % side, gl_InstanceID / side);
    vec3 foot = vec3((vec2(within) + 0.5) / float(side) * 2.0 - 1.0, 0.0), along;
    if (axis >= 0) {
        foot = vec3(-1.0, -1.0, 0.0);
        along = vec3(0.0);
        along[axis] = 0.5;
        v_color = axis == 0 ? vec3(0.95, 0.25, 0.22) : axis == 1 ? vec3(0.35, 0.85, 0.30) : vec3(0.35, 0.55, 1.0);
    } else {
        ivec2 texel = ivec2(u_part.xy * vec2(size)) + within;
        along = normalize(texelFetch(s_stored, texel, 0).xyz * 2.0 - 1.0) * 3.4 / float(side);
        v_color = vec3(1.0, 0.97, 0.85);
    }
    v_along = gl_VertexID < 2 ? 0.0 : 1.0;
    vec4 a = u_clip_from_world * vec4(foot, 1.0), b = u_clip_from_world * vec4(foot + along, 1.0);
    vec2 direction = (b.xy / b.w - a.xy / a.w) * u_size;
    float pixels = length(direction);
    gl_Position = vec4(0.0, 0.0, 2.0, 1.0);  // outside of the view: draws nothing
    if (a.w <= 0.0 || b.w <= 0.0) return;
    vec2 across = pixels < 1e-3 ? vec2(1.0, 0.0) : vec2(-direction.y, direction.x) / pixels;
    // The width is a share of the picture, so that needles keep their shape in a larger one.
    float wide = (axis >= 0 ? 0.009 : v_along == 0.0 ? 0.0055 : 0.001) * u_size.y;
    vec4 end = v_along == 0.0 ? a : b;
    gl_Position = end + vec4((gl_VertexID % 2 == 0 ? across : -across) * wide / u_size * end.w, 0.0, 0.0);
}
