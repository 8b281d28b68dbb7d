// Errors as colours, sRGB-encoded: black at 0, then purple and orange, pale yellow at 1. Lightness increases
// monotonically, so the scale is readable without colour.

vec3 heat(float share) {
    float place = clamp(share, 0.0, 1.0) * 5.0;
    vec3 color = mix(vec3(0.00, 0.00, 0.02), vec3(0.26, 0.04, 0.41), clamp(place, 0.0, 1.0));
    color = mix(color, vec3(0.58, 0.15, 0.40), clamp(place - 1.0, 0.0, 1.0));
    color = mix(color, vec3(0.87, 0.32, 0.23), clamp(place - 2.0, 0.0, 1.0));
    color = mix(color, vec3(0.99, 0.65, 0.04), clamp(place - 3.0, 0.0, 1.0));
    return mix(color, vec3(0.99, 1.00, 0.65), clamp(place - 4.0, 0.0, 1.0));
}

// Returns the colour of a positive value on a logarithmic scale from 10^low to 10^high.
vec3 log_heat(float value, float low, float high) {
    return heat((log2(max(value, 1e-6)) / log2(10.0) - low) / (high - low));
}
