// An evening sky in linear light, so that the sea can mirror it: in closed form, or SKY_CUBE, whose sun stands still.

#ifdef SKY_CUBE
uniform samplerCube s_sky;

vec3 sky(vec3 direction, vec3 to_sun) { return textureLod(s_sky, direction, 0.0).rgb; }
#else
vec3 sky(vec3 direction, vec3 to_sun) {
    float up = max(direction.y, 0.0);
    float beside = 0.5 + 0.5 * dot(normalize(direction.xz + vec2(1e-6, 0.0)), normalize(to_sun.xz + vec2(1e-6, 0.0)));
    float low = exp(-3.0 * max(to_sun.y, 0.0));  // 1 with the sun on the horizon
    vec3 zenith = mix(vec3(0.08, 0.22, 0.55), vec3(0.022, 0.055, 0.17), low);
    vec3 middle = mix(vec3(0.30, 0.48, 0.76), vec3(0.17, 0.17, 0.31), low);
    vec3 warm = mix(vec3(0.72, 0.80, 0.88), vec3(1.10, 0.36, 0.10), low);
    vec3 cool = mix(vec3(0.55, 0.68, 0.82), vec3(0.34, 0.19, 0.27), low);
    vec3 horizon = mix(cool, warm, beside * beside * beside);
    vec3 light = mix(middle, zenith, 1.0 - exp(-3.5 * up));
    light = mix(light, horizon, exp(-7.5 * up));
    float near = max(dot(direction, to_sun), 0.0);
    return light + vec3(1.0, 0.50, 0.16) * (0.45 * pow(near, 18.0) + 1.5 * pow(near, 420.0)) * step(-0.1, to_sun.y);
}
#endif

vec3 sun_disc(vec3 direction, vec3 to_sun) {
    return vec3(30.0, 22.0, 12.0) * smoothstep(0.99988, 0.99993, dot(direction, to_sun));
}

// Compresses bright light to values below 1. It keeps some of its colour.
vec3 exposed(vec3 light) { return 1.0 - exp(-1.25 * light); }
