// The ground of the court: where it lies below the water there is a puddle, and where the floor is displaced it rises
// above.

uniform vec4 u_ground[6];  // radians a metre along x and z, amplitude, phase
uniform float u_water;
uniform float u_rise;  // metres; 0 is flat

// Its height and its slopes along x and z.
vec3 ground_at(vec2 place) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 6; ++i) {
        vec4 wave = u_ground[i];
        float angle = dot(wave.xy, place) + wave.w;
        sum += wave.z * vec3(cos(angle), -sin(angle) * wave.xy);
    }
    return sum;
}

// The floor's height and slopes, metres.
vec3 floor_at(vec3 ground) {
    float above = max(0.0, ground.x - u_water);
    return u_rise * above * vec3(above, 2.0 * ground.yz);
}
