// Directions from the stored values of normal maps.

// Decodes c = 255 (0.5 x + 0.5). `stored` is the sampler's value in [0, 1]. The result is not normalised, and a flat
// texel (128) is not exactly 0.
vec3 decode_normal(vec3 stored) { return stored * 2.0 - 1.0; }

// Decodes an 8-bit map with c = 127 x + 128, where 128 is exactly 0.
vec3 decode_normal_128(vec3 stored) { return (stored * 255.0 - 128.0) / 127.0; }

// Decodes x and y in [-1, 1]. The normal has unit length and z >= 0. Filtering may round (x, y) to a length above 1, so
// the radicand is clamped to 0: the root of a negative number is NaN.
vec3 decode_normal_xy(vec2 xy) { return vec3(xy, sqrt(max(0.0, 1.0 - dot(xy, xy)))); }

// Decodes an octahedral map, stored in [-1, 1] (Meyer et al. 2010; Cigolle et al. 2014). The lower half is folded over
// the corners. Here 0 counts as positive.
vec3 decode_octahedral(vec2 stored) {
    vec3 n = vec3(stored, 1.0 - abs(stored.x) - abs(stored.y));
    float below = max(-n.z, 0.0);
    n.x += n.x >= 0.0 ? -below : below;
    n.y += n.y >= 0.0 ? -below : below;
    return normalize(n);
}
