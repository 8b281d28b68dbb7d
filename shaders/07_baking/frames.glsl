// The frame that is made of the interpolated normal and tangent. A baker and a renderer must use the same one.

#if defined EACH_UNIT || defined GRAM_SCHMIDT
vec3 frame_normal(vec3 n) { return normalize(n); }
#else
vec3 frame_normal(vec3 n) { return n; }
#endif

vec4 frame_tangent(vec3 normal, vec4 tangent) {
#if defined EACH_UNIT
    return vec4(normalize(tangent.xyz), tangent.w);
#elif defined GRAM_SCHMIDT
    vec3 across = normalize(cross(normal, tangent.xyz));
    return vec4(cross(across, normalize(normal)), tangent.w);
#else
    return tangent;
#endif
}

// Returns `unit`, or `otherwise` if a degenerate normal or frame has made it NaN or infinite.
vec3 finite_or(vec3 unit, vec3 otherwise) { return dot(unit, unit) < 1.5 ? unit : otherwise; }
