// The heights of the planet, in closed form: noise for continents and ridges, craters, a calm sea. The twin of
// labs/09_planet/heights.h. Lengths are in radii of the planet.

uniform int u_seed;
uniform int u_detail;
uniform float u_height;
const int crater_count = 14;
uniform vec4 u_craters[crater_count];  // middle, and 1 - cos of the rim's angle

// Returns the hash PCG3D of three integers (Jarzynski and Olano 2020).
uvec3 scrambled(uvec3 v) {
    v = v * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v ^= v >> 16u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    return v;
}

// Returns Perlin's noise with a fifth-degree blend (2002), whose gradient is continuous.
float noise(vec3 p) {
    vec3 low = floor(p), f = p - low;
    vec3 w = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    uvec3 cell = uvec3(ivec3(low));
    float sum = 0.0;
    for (uint corner = 0u; corner < 8u; ++corner) {
        uvec3 at = uvec3(corner & 1u, corner >> 1u & 1u, corner >> 2u);
        vec3 slope = vec3(scrambled(cell + at) >> 16u) / 32767.5 - 1.0;
        vec3 side = mix(1.0 - w, w, vec3(at));
        sum += side.x * side.y * side.z * dot(f - vec3(at), slope);
    }
    return sum;
}

// Returns the elevation of the ground at the unit vector r. Negative below the sea.
float elevation(vec3 r) {
    float shift = 19.7 * float(u_seed);
    vec3 turned = vec3(shift, -shift, 0.5 * shift);
    float land = noise(1.35 * r + vec3(3.1, 7.7, 1.3) + turned) + 0.5 * noise(2.9 * r + vec3(11.3, 5.1, 8.9) + turned) +
                 0.22 * noise(6.1 * r + vec3(2.7, 17.9, 4.3) + turned) + 0.06;
    float inland = 1.0 / (exp(-16.0 * (land - 0.16)) + 1.0);
    float ridges = 0.0, scale = 5.3, strength = 1.0;
    for (int octave = 0; octave < u_detail; ++octave) {
        float i = float(octave), n = noise(scale * r + vec3(5.7 * i + 1.9, 3.3, 9.1 * i) + turned);
        ridges += strength * (0.55 - sqrt(5.0 * n * n + 0.034));
        scale *= 2.07;
        strength *= 0.47;
    }
    float sum = 0.05 * land + 0.045 * inland * (ridges + 0.35);
    for (int i = 0; i < crater_count; ++i) {
        // 1 - cos of an angle is half the square of its chord, without cancellation near the middle.
        vec3 chord = r - u_craters[i].xyz;
        float d = 0.5 * dot(chord, chord) / u_craters[i].w;
        if (d > 4.0) continue;
        sum += 0.14 * sqrt(u_craters[i].w) * (0.6 * exp(-5.0 * (d - 1.0) * (d - 1.0)) - exp(-2.0 * d * d));
    }
    return sum;
}

// Returns the height of the ground or of the sea, with a shore without a crease.
float height_of_elevation(float x) { return 0.5 * u_height * (x + sqrt(x * x + 0.002 * 0.002)); }
