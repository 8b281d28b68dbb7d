// Tangent frames, and directions in them. tangent.w is the handedness, 1 or -1: bitangent = tangent.w * cross(normal,
// tangent.xyz).

// Returns a frame whose columns are tangent, bitangent and normal, made orthonormal by Gram-Schmidt; the normal keeps
// its direction. The arguments may be interpolated: they need not be normalised or perpendicular.
mat3 tangent_frame(vec3 normal, vec4 tangent) {
    vec3 n = normalize(normal);
    vec3 t = normalize(tangent.xyz - dot(tangent.xyz, n) * n);
    return mat3(t, tangent.w * cross(n, t), n);
}

// Transforms a direction from tangent space to the space of `normal` and `tangent`. The result is normalised.
vec3 from_tangent_space(vec3 direction, vec3 normal, vec4 tangent) {
    return normalize(tangent_frame(normal, tangent) * direction);
}

// The inverse of from_tangent_space(): the inverse of an orthonormal frame is its transpose.
vec3 to_tangent_space(vec3 direction, vec3 normal, vec4 tangent) {
    return normalize(direction * tangent_frame(normal, tangent));
}

// Returns a frame whose columns are tangent, bitangent and normal as interpolated, neither normalised nor
// perpendicular. This is the frame of MikkTSpace (Mikkelsen 2008) with the bitangent of each pixel. The program that bakes
// a map decides which frame it needs.
mat3 interpolated_frame(vec3 normal, vec4 tangent) {
    return mat3(tangent.xyz, tangent.w * cross(normal, tangent.xyz), normal);
}

vec3 from_interpolated_frame(vec3 direction, vec3 normal, vec4 tangent) {
    return normalize(interpolated_frame(normal, tangent) * direction);
}

// The inverse of from_interpolated_frame(). Uses the rows of the inverse times the determinant, which has the sign of
// tangent.w.
vec3 to_interpolated_frame(vec3 direction, vec3 normal, vec4 tangent) {
    mat3 frame = interpolated_frame(normal, tangent);
    mat3 rows = mat3(cross(frame[1], frame[2]), cross(frame[2], frame[0]), cross(frame[0], frame[1]));
    return normalize(sign(tangent.w) * (direction * rows));
}

// Returns a frame from screen derivatives, without vertex tangents (Schuler 2013). Pass dFdx and dFdy of position and
// uv. `normal` has unit length. The first two columns are the gradients of u and v on the surface, scaled together so
// that the longer one has unit length. They are not perpendicular where the uv are sheared, and zero where the uv do
// not change.
mat3 cotangent_frame(vec3 normal, vec3 position_dx, vec3 position_dy, vec2 uv_dx, vec2 uv_dy) {
    vec3 across_x = cross(position_dy, normal), across_y = cross(normal, position_dx);
    // If the screen runs against the surface's orientation, both columns would point the wrong way.
    float side = dot(position_dx, across_x) < 0.0 ? -1.0 : 1.0;
    vec3 t = side * (across_x * uv_dx.x + across_y * uv_dy.x);
    vec3 b = side * (across_x * uv_dx.y + across_y * uv_dy.y);
    float longest = max(dot(t, t), dot(b, b));
    float scale = longest > 0.0 ? inversesqrt(longest) : 0.0;
    return mat3(t * scale, b * scale, normal);
}
