// A threshold for alpha that differs from place to place and stays where it is when the camera moves: on average as
// much of a pixel is left as alpha says (Wyman and McGuire 2017).

float hash_of(vec2 p) { return fract(1e4 * sin(17.0 * p.x + 0.1 * p.y) * (0.1 + abs(sin(13.0 * p.y + p.x)))); }
float hash_of(vec3 p) { return hash_of(vec2(hash_of(p.xy), p.z)); }

float hashed_threshold(vec3 place) {
    // Cells about as wide as a pixel: between two powers of two.
    float wide = max(max(length(dFdx(place)), length(dFdy(place))), 1e-9), scale = -log2(wide);
    vec2 scales = exp2(vec2(floor(scale), ceil(scale)));
    float between = fract(scale);
    float x = mix(hash_of(floor(scales.x * place)), hash_of(floor(scales.y * place)), between);
    // A mean of two even numbers is not even: by its distribution it is again.
    float a = min(between, 1.0 - between);
    if (a < 1e-4) return clamp(x, 1e-6, 1.0);
    float even = x < a         ? x * x / (2.0 * a * (1.0 - a))
                 : x < 1.0 - a ? (x - 0.5 * a) / (1.0 - a)
                               : 1.0 - (1.0 - x) * (1.0 - x) / (2.0 * a * (1.0 - a));
    return clamp(even, 1e-6, 1.0);
}
