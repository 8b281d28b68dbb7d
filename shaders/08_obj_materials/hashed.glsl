// A random threshold for alpha. It is fixed to places on the surface, so that it does not flicker when the camera
// moves. On average the share of a pixel that passes is alpha (Wyman and McGuire 2017).

float hash_of(vec2 p) { return fract(1e4 * sin(17.0 * p.x + 0.1 * p.y) * (0.1 + abs(sin(13.0 * p.y + p.x)))); }
float hash_of(vec3 p) { return hash_of(vec2(hash_of(p.xy), p.z)); }

float hashed_threshold(vec3 place) {
    // Mixes the hashes of two sizes of cells, the powers of two above and below the width of a pixel.
    float wide = max(max(length(dFdx(place)), length(dFdy(place))), 1e-9), scale = -log2(wide);
    vec2 scales = exp2(vec2(floor(scale), ceil(scale)));
    float between = fract(scale);
    float x = mix(hash_of(floor(scales.x * place)), hash_of(floor(scales.y * place)), between);
    // The mix of two uniform numbers is not uniform. Its distribution function makes it uniform again.
    float a = min(between, 1.0 - between);
    if (a < 1e-4) return clamp(x, 1e-6, 1.0);
    float even = x < a         ? x * x / (2.0 * a * (1.0 - a))
                 : x < 1.0 - a ? (x - 0.5 * a) / (1.0 - a)
                               : 1.0 - (1.0 - x) * (1.0 - x) / (2.0 * a * (1.0 - a));
    return clamp(even, 1e-6, 1.0);
}
