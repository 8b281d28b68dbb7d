// How finely an edge of a patch is to be cut. Each is symmetric in the edge's ends to the last bit, so that two patches
// that share the edge agree; levels run from 1 to 64, and one that is not a number becomes 1.

float possible_level(float level) { return level > 1.0 ? min(level, 64.0) : 1.0; }

// 2^finest at `nearest` metres or nearer, 2^coarsest at `farthest` or farther, the exponent linear between (Luna 2012).
float level_by_distance(float distance, float nearest, float farthest, float finest, float coarsest) {
    float share = clamp((distance - nearest) / (farthest - nearest), 0.0, 1.0);
    return possible_level(exp2(mix(finest, coarsest, share)));
}

// The edge's length as the diameter of a sphere around its middle, in pixels, over the pixels that one segment may have:
// it does not fall when the edge turns towards the eye. `pixels_per_radian` is the picture's height in pixels over
// 2 tan(field of view / 2).
float level_by_size(vec3 a, vec3 b, vec3 eye, float pixels_per_radian, float pixels_per_segment) {
    float pixels = length(a - b) * pixels_per_radian / length((a + b) * 0.5 - eye);
    return possible_level(pixels / pixels_per_segment);
}

// Chords of length s leave a curve h by up to s^2 |h''| / 8: the segments that an edge of `length_` metres at `distance`
// metres needs to be right within `budget` pixels, where `curvature` is the largest |h''| along it, in 1/metre.
float level_by_error(float length_, float curvature, float distance, float pixels_per_radian, float budget) {
    return possible_level(length_ * sqrt(abs(curvature) * pixels_per_radian / (8.0 * budget * distance)));
}
