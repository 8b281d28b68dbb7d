// Frames at a surface, and directions in them. In `tangent`, w is the handedness, 1 or -1:
// bitangent = tangent.w * cross(normal, tangent.xyz).

// Columns tangent, bitangent, normal: unit and at right angles by Gram-Schmidt, which keeps the normal's direction. Both
// may be interpolated and need not be normalised or perpendicular.
mat3 tangent_frame(vec3 normal, vec4 tangent) {
    vec3 n = normalize(normal);
    vec3 t = normalize(tangent.xyz - dot(tangent.xyz, n) * n);
    return mat3(t, tangent.w * cross(n, t), n);
}

// From tangent space to the space of `normal` and `tangent`, normalised.
vec3 from_tangent_space(vec3 direction, vec3 normal, vec4 tangent) {
    return normalize(tangent_frame(normal, tangent) * direction);
}

// The other way round; a frame at right angles is undone by its transpose.
vec3 to_tangent_space(vec3 direction, vec3 normal, vec4 tangent) {
    return normalize(direction * tangent_frame(normal, tangent));
}

// Columns tangent, bitangent, normal as they are interpolated, neither unit nor perpendicular: the frame of MikkTSpace and
// of all that bake for it (Mikkelsen 2008). The frame is a convention: whoever makes the map decides.
mat3 interpolated_frame(vec3 normal, vec4 tangent) {
    return mat3(tangent.xyz, tangent.w * cross(normal, tangent.xyz), normal);
}

vec3 from_interpolated_frame(vec3 direction, vec3 normal, vec4 tangent) {
    return normalize(interpolated_frame(normal, tangent) * direction);
}

// The other way round, by the rows of the inverse, times the determinant, which has the sign of tangent.w.
vec3 to_interpolated_frame(vec3 direction, vec3 normal, vec4 tangent) {
    mat3 frame = interpolated_frame(normal, tangent);
    mat3 rows = mat3(cross(frame[1], frame[2]), cross(frame[2], frame[0]), cross(frame[0], frame[1]));
    return normalize(sign(tangent.w) * (direction * rows));
}

// A frame without a tangent at the vertices, from how position and uv change to two neighbours: pass dFdx and dFdy of both
// (Schuler 2013). The first two columns are the gradients of u and v on the surface, scaled together so that the longer is
// unit: not at right angles where the uv are sheared, and zero where the uv do not change. `normal` is unit.
mat3 cotangent_frame(vec3 normal, vec3 position_dx, vec3 position_dy, vec2 uv_dx, vec2 uv_dy) {
    vec3 across_x = cross(position_dy, normal), across_y = cross(normal, position_dx);
    // The screen may run against the surface's orientation: then both columns point the wrong way.
    float side = dot(position_dx, across_x) < 0.0 ? -1.0 : 1.0;
    vec3 t = side * (across_x * uv_dx.x + across_y * uv_dy.x);
    vec3 b = side * (across_x * uv_dx.y + across_y * uv_dy.y);
    float longest = max(dot(t, t), dot(b, b));
    float scale = longest > 0.0 ? inversesqrt(longest) : 0.0;
    return mat3(t * scale, b * scale, normal);
}
