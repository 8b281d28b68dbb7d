// How maps are read.

/// The mip level whose texels are as wide as a pixel, along the longer side of its footprint.
float level_of(sampler2D map, vec2 right, vec2 up) {
    vec2 size = vec2(textureSize(map, 0));
    right *= size;
    up *= size;
    return max(0.5 * log2(max(max(dot(right, right), dot(up, up)), 1e-20)), 0.0);
}

/// The mean of 32 x 32 places of a pixel's footprint, without mip levels.
vec4 by_samples(sampler2D map, vec2 uv, vec2 right, vec2 up) {
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 1024; ++i)
        sum += textureLod(map, uv + right * ((float(i % 32) + 0.5) / 32.0 - 0.5) +
                               up * ((float(i / 32) + 0.5) / 32.0 - 0.5), 0.0);
    return sum / 1024.0;
}

/// FILTER 0: the nearest texel; 1: mip levels as wide as the footprint is long; 2: up to TAPS places along the longer
/// side of the footprint, from mip levels as wide as the shorter one; 3: 1024 samples.
vec4 filtered(sampler2D map, vec2 uv) {
    vec2 right = dFdx(uv), up = dFdy(uv);
#if FILTER == 0
    vec2 size = vec2(textureSize(map, 0));
    return textureLod(map, (floor(uv * size) + 0.5) / size, 0.0);
#elif FILTER == 1
    return texture(map, uv);
#elif FILTER == 2
    bool is_wide = dot(right, right) > dot(up, up);
    vec2 longer = is_wide ? right : up, shorter = is_wide ? up : right;
    float taps = clamp(ceil(length(longer) / max(length(shorter), 1e-12)), 1.0, float(TAPS));
    vec4 sum = vec4(0.0);
    for (float i = 0.5; i < taps; i += 1.0)
        sum += textureGrad(map, uv + longer * (i / taps - 0.5), longer / taps, shorter);
    return sum / taps;
#else
    return by_samples(map, uv, right, up);
#endif
}
