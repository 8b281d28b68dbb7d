// What normal maps store, back to directions.

// Of a map with c = 255 (0.5 x + 0.5), as the sampler gives it, in [0, 1]. Not unit, and not quite 0 for the 128 of a flat
// texel.
vec3 decode_normal(vec3 stored) { return stored * 2.0 - 1.0; }

// Of an 8-bit map with c = 127 x + 128, where 128 is 0 exactly.
vec3 decode_normal_128(vec3 stored) { return (stored * 255.0 - 128.0) / 127.0; }

// Of x and y alone, in [-1, 1]: the normal points out of the surface and has unit length. Filtering can make x and y too long by a
// rounding, and the root of a negative number is not a number.
vec3 decode_normal_xy(vec2 xy) { return vec3(xy, sqrt(max(0.0, 1.0 - dot(xy, xy)))); }

// Of an octahedral map, in [-1, 1] (Meyer et al. 2010; Cigolle et al. 2014). The lower half is folded over the corners,
// where the sign of 0 must count as 1.
vec3 decode_octahedral(vec2 stored) {
    vec3 n = vec3(stored, 1.0 - abs(stored.x) - abs(stored.y));
    float below = max(-n.z, 0.0);
    n.x += n.x >= 0.0 ? -below : below;
    n.y += n.y >= 0.0 ? -below : below;
    return normalize(n);
}
