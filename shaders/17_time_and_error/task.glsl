// Lab 17, your tasks: what an error in pixels allows, and the cheapest method that keeps it.

#include "common/unfinished.glsl"

const int plain = 0, normal_map = 1, parallax = 2, exact = 3;  // from cheap to dear

// TASK 17.1 (3 points): how many pixels a metre of relief is here, on a picture of `size` pixels. `clip` is this point
// in clip space, `along` the change of it per metre along the normal: clip_from_world * vec4(normal, 0). A metre is
// too long, so take the derivative: how fast the pixel moves when the point begins to move along the normal.
//(pixels
float pixels_per_metre(vec4 clip, vec4 along, vec2 size) {
    //[solution
    vec2 ndc = clip.xy / clip.w;
    return length(0.5 * size * (along.xy - ndc * along.w)) / clip.w;
    //]starter
    //| return unfinished(100.0);
    //]
}
//)

// Given, because you wrote it as task 14.3: by how much a height in [0, 1] may be off if the error on the screen may be
// `budget` pixels and the relief is `scale` metres deep; 1e30 for a relief without depth.
float tolerated(float budget, float pixels_per_metre, float scale) {
    float pixels = pixels_per_metre * scale;
    return pixels > 0.0 ? budget / pixels : 1e30;
}

// TASK 17.2 (2 points): spend the budget. thinned() makes the relief thinner: it cuts the heights from `lowest` to
// `highest` off below and above, by as much as possible without moving any height by more than `max_error` (the lab
// passes 7/8 of tolerated() as `max_error`, and 1/8 as the tolerance of 17.3). It returns the lowest and the highest
// height that are left; if nothing is left, both are the middle.
vec2 thinned(float lowest, float highest, float max_error) {
    //[solution
    float middle = 0.5 * (lowest + highest);
    return vec2(min(lowest + max_error, middle), max(highest - max_error, middle));
    //]starter
    //| return unfinished(vec2(lowest, highest));
    //]
}

// TASK 17.3 (4 points): the coarsest level of the height map that is off by no more than `tolerance`. errors[k] is the
// error of level k; it never falls with k, and there are `count` of them. Between two levels interpolate level and
// error linearly, so that nothing jumps when the tolerance grows. Return level 0 also if even its error is too large.
//(level
float coarsest_level(float errors[12], int count, float tolerance) {
    //[solution
    int level = 0;
    while (level + 1 < count && errors[level + 1] <= tolerance) ++level;
    if (level + 1 == count || errors[level] >= tolerance) return float(level);
    return float(level) + (tolerance - errors[level]) / (errors[level + 1] - errors[level]);
    //]starter
    //| return unfinished(0.0);
    //]
}
//)

// TASK 17.4 (3 points): the cheapest method that keeps the budget. `left` is the range that thinned() left of the
// relief: if it is empty, use the plane in its middle, lit by the normal map, or plain if `bumps` says that no bumps
// are left. Otherwise choose between parallax, which needs `taps` taps, and the exact search, which takes about as
// long as `exact_taps` taps: if both cost the same, take the march.
int cheapest(vec2 left, float bumps, float taps, float exact_taps) {
    //[solution
    if (left.x >= left.y) return bumps > 0.0 ? normal_map : plain;
    return taps <= exact_taps ? parallax : exact;
    //]starter
    //| unfinished(0.0);
    //| return exact;
    //]
}

// TASK 17.5 (3 points): where bumps are smaller than a pixel the normal map returns their mean, a vector that is the
// shorter the more they differ. They still spread the highlight: by Toksvig's factor a shininess s becomes l s / (l +
// s (1 - l)), where l is the length of the mean, at most 1 (bytes can make it a little longer).
float spread_shininess(vec3 mean, float shininess) {
    //[solution
    float l = min(length(mean), 1.0);
    return l * shininess / (l + shininess * (1.0 - l));
    //]starter
    //| return unfinished(8.0);
    //]
}

// TASK 17.6 (2 points): fade the bumps out without a jump. From level `flat_level` on the normal map is as good as
// flat, and a pixel reads `level` of it. A pixel that may be off by `budget` pixels needs no bump that is smaller than
// that: it could as well read a level whose texels are that much wider (narrower for a budget below 1). The result is
// 1 if that level is still at least a whole level finer than flat_level, 0 from flat_level on, and linear in between.
float bumps_left(float level, float flat_level, float budget) {
    //[solution
    return clamp(flat_level - level - log2(budget), 0.0, 1.0);
    //]starter
    //| return unfinished(1.0);
    //]
}
