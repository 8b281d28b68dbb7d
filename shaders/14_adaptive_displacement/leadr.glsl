// The slopes within a pixel, and their highlight (LEADR mapping: Dupuy and others 2013). Directions are in the tangent
// frame of the undisplaced surface: x along u, y along v.

#include "common/slope_moments.glsl"

struct Slopes {
    vec2 mean;
    vec3 variance;  // of the slopes that neither the geometry nor the mean has
};

// What the eye sees of slopes along its own direction. A facet with the slope s has the area c - s on the picture, where c is
// the cotangent of the angle between the surface's normal and the eye. Where c < s, the facet faces away.
struct Sight {
    vec2 direction;
    float cotangent;
    float area;    // the mean of max(c - s, 0)
    float facing;  // share of the facets with s < c
};

Sight sight_of(Slopes slopes, vec3 to_eye) {
    Sight sight;
    float flat_ = max(length(to_eye.xy), 1e-4);
    sight.direction = to_eye.xy / flat_;
    sight.cotangent = to_eye.z / flat_;
    vec2 along = covariance_matrix(slopes.variance) * sight.direction;
    float deviation = sqrt(max(dot(sight.direction, along), 1e-8));
    float rest = sight.cotangent - dot(slopes.mean, sight.direction), t = rest / deviation;
    // The distribution function of a Gaussian, within 1.5e-4 (Bowling and others 2009).
    sight.facing = 1.0 / (1.0 + exp(-clamp(1.5976 * t + 0.07056 * t * t * t, -80.0, 80.0)));
    sight.area = max(rest * sight.facing + deviation * 0.39894228 * exp(-0.5 * t * t), 1e-6);
    return sight;
}

// Returns the mean slope that the eye sees: slopes that lean towards it cover more of the picture.
vec2 seen_slope(Slopes slopes, vec3 to_eye) {
    Sight sight = sight_of(slopes, to_eye);
    return slopes.mean - covariance_matrix(slopes.variance) * sight.direction * (sight.facing / sight.area);
}

// Returns the highlight's share of its brightest value. `alpha2` is the squared roughness alpha^2 of the surface, a
// Beckmann distribution of slopes with the variance alpha^2 / 2 along each axis. The lost slopes make it
// alpha^2 + 2 sigma^2.
float highlight(Slopes slopes, float alpha2, vec3 to_eye, vec3 to_light) {
    vec3 halfway = to_eye + to_light;
    if (halfway.z < 1e-3) return 0.0;
    mat2 lost = covariance_matrix(slopes.variance), whole = lost + mat2(0.5 * alpha2);
    vec2 off = -halfway.xy / halfway.z - slopes.mean, in_variances = inverse(whole) * off;
    float lobe = exp(-0.5 * dot(off, in_variances)) * 0.5 * alpha2 / sqrt(determinant(whole));
    // The mean of those lost slopes that mirror the light, and the area on the picture that they have.
    Sight sight = sight_of(slopes, to_eye);
    float mirrors = dot(slopes.mean + lost * in_variances, sight.direction);
    return lobe * max(sight.cotangent - mirrors, 0.0) / sight.area;
}
