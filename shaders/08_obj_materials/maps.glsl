// The filters of maps.

/// Returns the mip level whose texels are as wide as the longer side of a pixel's footprint.
float level_of(sampler2D map, vec2 right, vec2 up) {
    vec2 size = vec2(textureSize(map, 0));
    right *= size;
    up *= size;
    return max(0.5 * log2(max(max(dot(right, right), dot(up, up)), 1e-20)), 0.0);
}

/// Returns the mean of 32 x 32 samples of level 0 over a pixel's footprint.
vec4 by_samples(sampler2D map, vec2 uv, vec2 right, vec2 up) {
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 1024; ++i)
        sum += textureLod(map, uv + right * ((float(i % 32) + 0.5) / 32.0 - 0.5) +
                               up * ((float(i / 32) + 0.5) / 32.0 - 0.5), 0.0);
    return sum / 1024.0;
}

/// Reads a map by the filter that is defined:
///  NEAREST_TEXEL: the nearest texel of level 0
///  MIP_LEVELS: trilinear; the mip level fits the longer side of the footprint
///  TAPS: anisotropic; up to TAPS samples along the longer side, whose mip level fits the shorter side
/// or, if none is defined, by 1024 samples
vec4 filtered(sampler2D map, vec2 uv) {
    vec2 right = dFdx(uv), up = dFdy(uv);
#if defined NEAREST_TEXEL
    vec2 size = vec2(textureSize(map, 0));
    return textureLod(map, (floor(uv * size) + 0.5) / size, 0.0);
#elif defined MIP_LEVELS
    return texture(map, uv);
#elif defined TAPS
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
