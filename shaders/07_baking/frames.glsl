// Which frame is made of the interpolated normal and tangent: what a baker and a renderer must agree on.

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

// Of a vector that should have unit length: itself, or `otherwise` where a normal or a frame of length 0 left no number.
vec3 finite_or(vec3 unit, vec3 otherwise) { return dot(unit, unit) < 1.5 ? unit : otherwise; }
