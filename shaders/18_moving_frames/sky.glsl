// The mist around the flock, as linear light.

vec3 mist(vec3 direction, vec3 to_light) {
    float up = direction.y;
    vec3 color = mix(vec3(0.050, 0.105, 0.125), vec3(0.016, 0.040, 0.075), smoothstep(-0.05, 0.5, up));
    color = mix(color, vec3(0.006, 0.020, 0.030), smoothstep(0.0, -0.5, up));
    float towards = max(dot(direction, to_light), 0.0);
    return color + vec3(0.42, 0.26, 0.12) * pow(towards, 6.0);
}
