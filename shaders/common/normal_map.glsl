// Normals out of a tangent-space normal map.

// What an 8-bit or 16-bit map stores, in [0, 1], to a direction; not unit, as stored.
vec3 decode_normal(vec3 stored) { return stored * 2.0 - 1.0; }

// From tangent space to the space of `normal` and `tangent`, unit. Both may be interpolated and need not be unit or
// perpendicular; tangent.w is the handedness, 1 or -1.
vec3 from_tangent_space(vec3 direction, vec3 normal, vec4 tangent) {
    vec3 n = normalize(normal);
    vec3 t = normalize(tangent.xyz - dot(tangent.xyz, n) * n);
    vec3 b = tangent.w * cross(n, t);
    return normalize(direction.x * t + direction.y * b + direction.z * n);
}
