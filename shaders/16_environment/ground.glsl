// The ground of the court. Below the water it is a puddle. A displaced floor rises above the water.

uniform vec4 u_ground[6];  // radians per metre along x and z, amplitude, phase
uniform float u_water;
uniform float u_rise;  // metres; 0 is flat

// Returns cosine and sine of an angle, with errors below 1e-6 and 2e-5. They are polynomials through Chebyshev nodes,
// after a range reduction to [-1/2, 1/2] turns. On a CPU the built-in functions take a quarter of the frame's time,
// since each reduces the angle for itself.
vec2 cosine_and_sine(float angle) {
    float turn = angle / 6.28318531;
    turn -= floor(turn + 0.5);
    float t = turn * turn;
    return vec2(((((-21.0654294 * t + 58.7869408) * t - 85.2708436) * t + 64.9285878) * t - 19.7389782) * t + 0.9999992,
                ((((33.5357062 * t - 74.9030857) * t + 81.4467145) * t - 41.3367821) * t + 6.2831607) * turn);
}

// Returns the height of the ground and its slopes along x and z.
vec3 ground_at(vec2 place) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 6; ++i) {
        vec4 wave = u_ground[i];
        vec2 cs = cosine_and_sine(dot(wave.xy, place) + wave.w);
        sum += wave.z * vec3(cs.x, -cs.y * wave.xy);
    }
    return sum;
}

// Returns the height of the displaced floor in metres, and its slopes along x and z.
vec3 floor_at(vec3 ground) {
    float above = max(0.0, ground.x - u_water);
    return u_rise * above * vec3(above, 2.0 * ground.yz);
}
