// Air around a planet of radius 1, for the picture only: the sunlight that is scattered into a ray, by a few samples.

uniform vec3 u_to_sun;

const float air_top = 1.16;       // radius at which the air ends
const float air_scale = 0.030;    // height at which the density falls to a third
const vec3 air_blue = vec3(0.9, 2.1, 5.0);

// Returns the share of sunlight that reaches a place through the air. mu is the cosine of its angle to the zenith.
vec3 sunlight(float height, float mu) {
    float way = exp(-max(height, 0.0) / air_scale) / (max(mu, 0.0) + 0.12);
    return exp(-air_blue * (0.055 * way)) * smoothstep(-0.22, 0.10, mu);
}

// Returns the light scattered into a ray between the eye and the distance `end`, in radii. `steps` is the number of
// samples.
vec3 air_light(vec3 eye, vec3 along, float end, int steps, out float opacity) {
    float b = dot(eye, along), c = dot(eye, eye) - air_top * air_top, root = b * b - c;
    opacity = 0.0;
    if (root <= 0.0) return vec3(0.0);
    float begin = max(0.0, -b - sqrt(root));
    end = min(end, -b + sqrt(root));
    if (end <= begin) return vec3(0.0);
    float size = (end - begin) / float(steps), facing = dot(along, u_to_sun);
    float forward = 0.75 + 0.75 * facing * facing, haze = 0.25 * pow(0.5 + 0.5 * facing, 12.0);
    vec3 light = vec3(0.0);
    float sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        vec3 at = eye + along * (begin + (float(i) + 0.5) * size);
        float from_centre = length(at), height = from_centre - 1.0;
        float density = exp(-max(height, 0.0) / air_scale), mu = dot(at, u_to_sun) / from_centre;
        sum += density * size;
        // The amount of air on the way from the sun to the place, and from there to the eye.
        float way = 0.055 * density / (max(mu, 0.0) + 0.12) + 0.35 * sum;
        light += density * size * smoothstep(-0.22, 0.10, mu) * exp(-air_blue * way);
    }
    opacity = 1.0 - exp(-sum * 2.2);
    return 0.9 * light * (air_blue * forward + vec3(6.0, 4.5, 3.0) * haze);
}

// Maps unbounded light, 0 or more, to a colour below 1.
vec3 exposed(vec3 light) { return 1.0 - exp(-1.35 * light); }
