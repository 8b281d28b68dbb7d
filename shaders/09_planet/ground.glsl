// The colours of the ground: sea, sand, forest, rock and snow. For the picture only.

// Returns colour and gloss. `elevation_` is in radii, negative in the sea; `up` and `normal` have unit length.
void ground(float elevation_, vec3 up, vec3 normal, vec3 place, out vec3 albedo, out float gloss) {
    float steep = 1.0 - clamp(dot(up, normal), 0.0, 1.0), cold = abs(up.y);
    // Irregular spots.
    vec3 waves = sin(37.0 * place + 3.0 * sin(19.0 * place.yzx));
    float wild = waves.x * waves.y * waves.z;
    float h = elevation_ + 0.0025 * wild;
    vec3 sea = mix(vec3(0.010, 0.105, 0.135), vec3(0.004, 0.018, 0.060), smoothstep(0.0, -0.012, elevation_));
    vec3 sand = vec3(0.52, 0.40, 0.22);
    vec3 forest = mix(vec3(0.045, 0.105, 0.030), vec3(0.125, 0.150, 0.045), 0.5 + 0.5 * wild);
    vec3 rock = mix(vec3(0.20, 0.155, 0.12), vec3(0.28, 0.25, 0.225), smoothstep(0.03, 0.055, h));
    vec3 snow = vec3(0.82, 0.86, 0.92);
    vec3 land = mix(sand, forest, smoothstep(0.0012, 0.0045, h));
    land = mix(land, rock, max(smoothstep(0.020, 0.032, h), smoothstep(0.07, 0.16, steep)));
    float snow_line = 0.052 - 0.045 * smoothstep(0.55, 0.95, cold);
    land = mix(land, snow, smoothstep(snow_line, snow_line + 0.006, h - 0.10 * max(0.0, steep - 0.10)));
    float is_land = smoothstep(-0.0004, 0.0006, elevation_);
    float ice = smoothstep(0.86, 0.90, cold + 0.03 * wild);
    albedo = mix(mix(sea, snow * 0.8, ice), land, is_land);
    gloss = (1.0 - is_land) * (1.0 - ice);
}
