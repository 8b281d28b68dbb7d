// Lab 17, yours: what an error in pixels allows, and which method is the cheapest that keeps it.

#include "common/unfinished.glsl"

const int plain = 0, normal_map = 1, parallax = 2, exact = 3;  // from cheap to dear

// TASK 17.1 (3 points): how many pixels a metre of relief is here, on a picture of `size` pixels. `clip` is this
// place in clip space, `along` what a metre along the normal adds to it: clip_from_world * vec4(normal, 0). A metre
// is too long, so take the derivative: how fast the pixel runs when the place begins to move along the normal.
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

// TASK 17.2 (3 points): spend the budget. tolerated() is by how much a height in [0, 1] may be off where the screen
// may show `budget` pixels of it and the relief is `scale` metres deep; 1e30 where that is nothing. thinned() makes
// the relief thinner: heights from `lowest` to `highest` are cut off below and above so that none moves by more than
// `most`, as much as that allows (the lab passes 7/8 of tolerated() as `most`, and 1/8 as the tolerance of 17.3). It gives the lowest and the highest that are left; when nothing is left both are
// the middle.
float tolerated(float budget, float pixels_per_metre, float scale) {
    //[solution
    float pixels = pixels_per_metre * scale;
    return pixels > 0.0 ? budget / pixels : 1e30;
    //]starter
    //| return unfinished(0.01);
    //]
}

vec2 thinned(float lowest, float highest, float most) {
    //[solution
    float middle = 0.5 * (lowest + highest);
    return vec2(min(lowest + most, middle), max(highest - most, middle));
    //]starter
    //| return unfinished(vec2(lowest, highest));
    //]
}

// TASK 17.3 (4 points): the coarsest level of the height map that is off by no more than `tolerance`. errors[k] is
// what level k is off by; it never falls, and there are `count` of them. Between two levels both level and error are
// mixed in the same shares, so that nothing jumps where the tolerance grows; level 0 also where it is off by too
// much.
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

// TASK 17.4 (3 points): the cheapest method that keeps the budget. `left` is what thinned() left of the relief: where
// that is nothing the plane in its middle will do, lit by the normal map, or plainly where `bumps` says that nothing
// of its bumps is left. Else parallax would read `taps` heights, and the exact search takes about as long as
// `exact_taps`: at a tie take the march.
int cheapest(vec2 left, float bumps, float taps, float exact_taps) {
    //[solution
    if (left.x >= left.y) return bumps > 0.0 ? normal_map : plain;
    return taps <= exact_taps ? parallax : exact;
    //]starter
    //| unfinished(0.0);
    //| return exact;
    //]
}

// TASK 17.5 (3 points): where bumps are smaller than a pixel the normal map gives their mean, a vector that is the
// shorter the more they differ. They still spread the highlight: by Toksvig's factor a shininess s becomes l s / (l +
// s (1 - l)), where l is the length of the mean, 1 at the most (bytes can make it a little more).
float spread_shininess(vec3 mean, float shininess) {
    //[solution
    float l = min(length(mean), 1.0);
    return l * shininess / (l + shininess * (1.0 - l));
    //]starter
    //| return unfinished(8.0);
    //]
}

// TASK 17.6 (2 points): no jump from bumps to none. From level `flat_level` on the normal map is as good as flat, and
// a pixel reads `level` of it. A pixel that may be `budget` pixels off needs no bump that is smaller than so many: it
// could as well read a level whose texels are that much wider (narrower for a budget below 1). What is left of the
// bumps is 1 where even that one is at least a whole level finer than flat_level, 0 from flat_level on, and in between
// a straight line.
float bumps_left(float level, float flat_level, float budget) {
    //[solution
    return clamp(flat_level - level - log2(budget), 0.0, 1.0);
    //]starter
    //| return unfinished(1.0);
    //]
}
