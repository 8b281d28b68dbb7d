// Lab 15, your tasks: the slope of a map's texel, the normal of a sea of two maps, the light that it mirrors, the
// spread of slopes that a pixel has lost, and its highlight. Task 15.1 is in labs/15_ocean/task.cpp.

#include "common/unfinished.glsl"

// TASK 15.2 (3 points): the slope of the water by one texel of a normal map, dh/dx and dh/dz. `texel` holds a unit
// normal (n + 1) / 2 whose third component points upwards and whose first two point along x and z. It was made for
// waves of amplitude 1 that are tiled once. Heights are multiplied by `amplitude`, the place by `tiles`.
//(slope
vec2 slope_of(vec3 texel, float amplitude, float tiles) {
    //[solution
    vec3 upright = texel * 2.0 - 1.0;
    return -upright.xy / upright.z * (amplitude * tiles);
    //]starter
    //| return unfinished(vec2(0.0));
    //]
}
//)

// TASK 15.3 (3 points): the normal of the sea, of unit length, y upwards. The height of the sea is the sum of two
// heights; `first` and `second` are their slopes along x and z.
//(normal
vec3 sea_normal(vec2 first, vec2 second) {
    //[solution
    vec2 both = first + second;
    return normalize(vec3(-both.x, 1.0, -both.y));
    //]starter
    //| return unfinished(vec3(0.0, 1.0, 0.0));
    //]
}
//)

// TASK 15.4 (3 points): fresnel() is the share of the light that water mirrors, by Schlick's approximation, for the
// cosine between normal and direction to the eye; the refractive index of water is 4/3. Below 0 count it as 0.
// reflected() is where the mirrored light comes from, of unit length like its arguments. One that comes from below the
// horizon has met another wave: mirror its y upwards.
//(fresnel
float fresnel(float cosine) {
    //[solution
    const float straight = 1.0 / 49.0;  // ((4/3 - 1) / (4/3 + 1))^2
    float rest = 1.0 - clamp(cosine, 0.0, 1.0);
    return straight + (1.0 - straight) * rest * rest * rest * rest * rest;
    //]starter
    //| return unfinished(0.02);
    //]
}

vec3 reflected(vec3 to_eye, vec3 normal) {
    //[solution
    vec3 from = 2.0 * dot(normal, to_eye) * normal - to_eye;
    return vec3(from.x, abs(from.y), from.z);
    //]starter
    //| return unfinished(vec3(0.0, 1.0, 0.0));
    //]
}
//)

// TASK 15.5 (3 points): what a filtered texel has lost: the variance of the slope along x (x), along z (y), and the
// covariance (z). `mean` holds the means of the slopes s over the texel, `moments` those of s.x s.x, s.y s.y, s.x s.y.
// Both belong to amplitude 1, tiled once: see 15.2. Rounding must not make a variance negative, nor the covariance
// larger than the root of the variances' product.
//(spread
vec3 spread(vec3 moments, vec2 mean, float amplitude, float tiles) {
    //[solution
    vec3 sigma = moments - vec3(mean * mean, mean.x * mean.y);
    sigma.xy = max(sigma.xy, 0.0);
    float most = sqrt(sigma.x * sigma.y);
    float scale = amplitude * tiles;
    return scale * scale * vec3(sigma.xy, clamp(sigma.z, -most, most));
    //]starter
    //| return unfinished(vec3(0.0));
    //]
}
//)

// TASK 15.6 (2 points): the highlight of a pixel whose slopes have this `variance` (as 15.5 has it), where the slope
// that would mirror the sun is off the mean one by `off`. A single slope shines by exp(-shininess d^2 / 2) if it is off
// by d. So the whole is a Gaussian with the matrix Sigma = variance + I / shininess, and
//     exp(-off^T Sigma^-1 off / 2) / (shininess sqrt(det Sigma)),
// which is the mean of the light over all slopes of the pixel.
//(highlight
float highlight(vec2 off, vec3 variance, float shininess) {
    //[solution
    vec3 sigma = variance + vec3(1.0, 1.0, 0.0) / shininess;
    float determinant = max(sigma.x * sigma.y - sigma.z * sigma.z, 1.0 / (shininess * shininess));
    float square = (sigma.y * off.x * off.x - 2.0 * sigma.z * off.x * off.y + sigma.x * off.y * off.y) / determinant;
    return exp(-0.5 * square) / (shininess * sqrt(determinant));
    //]starter
    //| return unfinished(0.0);
    //]
}
//)
