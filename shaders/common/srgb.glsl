// The sRGB transfer function (IEC 61966-2-1). Shaders encode their output themselves, once, at their end: an sRGB
// framebuffer rounds differently on different CPUs.

vec3 srgb_from_linear(vec3 light) {
    vec3 positive = max(light, vec3(0.0));
    vec3 curve = 1.055 * pow(positive, vec3(1.0 / 2.4)) - 0.055;
    return mix(curve, 12.92 * positive, lessThanEqual(positive, vec3(0.0031308)));
}
