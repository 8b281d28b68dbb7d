// A surface pressed in by a height map: height 1 stays on the base, 0 lies `scale` metres inside.

vec3 displaced(vec3 position, vec3 normal, float height, float scale) {
    return position + scale * (height - 1.0) * normal;
}

// The unit normal of the displaced surface. du, dv are dP/du and dP/dv of the base, normal_du and normal_dv how its unit
// normal turns, slope is dh/du and dh/dv in the same u and v. Without the turning slopes are wrong by
// 1 + scale (h - 1) / radius (Blinn 1978 left it out). Where the surface has no normal it is the base's.
vec3 displaced_normal(vec3 du, vec3 dv, vec3 normal, vec3 normal_du, vec3 normal_dv, float height, vec2 slope,
                      float scale) {
    float depth = scale * (height - 1.0);
    vec3 across = cross(du + depth * normal_du + scale * slope.x * normal, dv + depth * normal_dv + scale * slope.y * normal);
    float side = dot(across, normal) < 0.0 ? -1.0 : 1.0, squared = dot(across, across);
    return squared > 0.0 ? side * inversesqrt(squared) * across : normal;
}
