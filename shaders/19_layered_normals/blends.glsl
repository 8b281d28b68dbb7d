// A layer of detail on a base: the formulas of the knob `blend`, and the exact answers to the knob `question`.
// The twin in double precision is labs/19_layered_normals/staff/exact.cpp.

//(blends
vec3 blended(vec3 base, vec3 detail) {
#if defined BLEND_LINEAR
    return normalize(base + detail);
#elif defined BLEND_OVERLAY
    // Of colours, by channel: 2 a b, or 1 - 2 (1 - a) (1 - b) where a is above 1/2.
    vec3 a = 0.5 * base + 0.5, b = 0.5 * detail + 0.5;
    return normalize(mix(2.0 * a * b, 1.0 - 2.0 * (1.0 - a) * (1.0 - b), step(0.5, a)) * 2.0 - 1.0);
#elif defined BLEND_WHITEOUT
    return normalize(vec3(base.xy + detail.xy, base.z * detail.z));
#elif defined BLEND_UDN
    return normalize(vec3(base.xy + detail.xy, base.z));
#elif defined BLEND_SWIZZLE
    return normalize(detail.x * vec3(base.z, base.y, -base.x) + detail.y * vec3(base.x, base.z, -base.y) +
                     detail.z * base);
#elif defined BLEND_RNM
    return rotated_onto(base, detail);
#else
    return sum_of_heights(base, detail);
#endif
}
//)

// Returns the exact normal. `height` is that of the detail, and `bend` has the second derivatives uu, uv, vv of the base, both
// in the unit of u and v. Two of the answers are tasks. Before these are right, errors are measured from what they give.
vec3 exact_blend(vec3 base, vec3 detail, float height, vec3 bend) {
    vec2 first = -base.xy / base.z, second = -detail.xy / detail.z;
#if defined ALONG_NORMAL
    // The derivatives of (u, v, h) + height * base.
    vec3 turn_u = base.z * (vec3(-bend.xy, 0.0) + base * dot(base.xy, bend.xy));
    vec3 turn_v = base.z * (vec3(-bend.yz, 0.0) + base * dot(base.xy, bend.yz));
    return normalize(cross(vec3(1.0, 0.0, first.x) + second.x * base + height * turn_u,
                           vec3(0.0, 1.0, first.y) + second.y * base + height * turn_v));
#elif defined IN_FRAME
    vec3 right = normalize(vec3(1.0, 0.0, first.x));
    return mat3(right, cross(base, right), base) * detail;
#elif defined SHORTEST_ARC
    return rotated_onto(base, detail);
#else
    return sum_of_heights(base, detail);
#endif
}
