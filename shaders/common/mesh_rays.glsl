// Watertight intersection of rays with triangles and boxes (Woop, Benthin and Wald 2013): two triangles with a shared
// edge leave no gap under any rounding.

// Returns 1 / direction, with components clamped to [-1e18, 1e18].
vec3 inverse_direction(vec3 direction) {
    bvec3 is_small = lessThanEqual(abs(direction), vec3(1e-18));
    vec3 large = mix(vec3(1e18), vec3(-1e18), lessThan(direction, vec3(0.0)));
    return mix(1.0 / mix(direction, vec3(1.0), is_small), large, is_small);
}

// Returns whether the ray overlaps the box between t = 0 and `end`. The box is slightly larger than its contents. `leaves`
// is enlarged, because three roundings may reverse the order of `enters` and `leaves` (Ize 2013).
bool meets_box(vec3 origin, vec3 inverse, float end, vec3 low, vec3 high) {
    vec3 a = (low - origin) * inverse, b = (high - origin) * inverse;
    vec3 near = min(a, b), far = max(a, b);
    float enters = max(max(near.x, near.y), max(near.z, 0.0)), leaves = min(min(far.x, far.y), min(far.z, end));
    return enters <= leaves * 1.0000004;
}

// Returns v with its axes permuted so that the largest component of `direction` becomes z. The permutation keeps the
// handedness.
vec3 in_ray_order(vec3 v, vec3 direction) {
    vec3 size = abs(direction);
    return size.x >= size.y && size.x >= size.z ? v.yzx : size.y >= size.z ? v.zxy : v;
}

// Returns the shear that maps the direction to (0, 0, 1), after in_ray_order().
vec3 ray_shear(vec3 direction) {
    vec3 d = in_ray_order(direction, direction);
    return vec3(d.x / d.z, d.y / d.z, 1.0 / d.z);
}

// Returns (t, weight of a, weight of b, facing), with t in multiples of the direction. `facing` is 1 for the front,
// where a, b, c run counter-clockwise, -1 for the back, and 0 for a miss. A ray through an edge may hit both
// neighbours. Without `precise` a compiler may round only one product of a difference. Then both neighbours could
// report a miss.
vec4 triangle_hit(vec3 origin, vec3 direction, vec3 shear, vec3 a, vec3 b, vec3 c) {
    precise vec3 p = in_ray_order(a - origin, direction), q = in_ray_order(b - origin, direction);
    precise vec3 r = in_ray_order(c - origin, direction);
    p.xy = p.xy - shear.xy * p.z;
    q.xy = q.xy - shear.xy * q.z;
    r.xy = r.xy - shear.xy * r.z;
    precise vec3 weights = vec3(r.x * q.y - r.y * q.x, p.x * r.y - p.y * r.x, q.x * p.y - q.y * p.x);
    bool any_below = weights.x < 0.0 || weights.y < 0.0 || weights.z < 0.0;
    bool any_above = weights.x > 0.0 || weights.y > 0.0 || weights.z > 0.0;
    float sum = weights.x + weights.y + weights.z;
    if ((any_below && any_above) || sum == 0.0) return vec4(0.0);
    vec3 shares = weights / sum;
    float t = shear.z * dot(shares, vec3(p.z, q.z, r.z));
    return vec4(t, shares.xy, (sum > 0.0) == (shear.z > 0.0) ? 1.0 : -1.0);
}
