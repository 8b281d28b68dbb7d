// Lab 11, your tasks: the march along the view ray, from the number of its steps to the taps where it ends.

#include "common/unfinished.glsl"

// A view ray in the relief. At t = 0 it enters at `uv`, at height 1; at t = 1 it reaches the ground, height 0, at
// uv + march. In between it is a straight line: at t its height is 1 - t.
struct ReliefRay {
    vec2 uv, march;
    float slant;  // the cosine between the ray and the surface's normal
    float level;  // of the height map, chosen once, before the march
};

// Two points on the ray between which it goes below the surface, and how far it runs above the surface there: the first
// gap is positive, the second is not. Where the ray begins on the surface, both points are t = 0, with the same gap.
struct Bracket {
    float before, after;
    float gap_before, gap_after;
};

const int bisection = 2, secant = 3, illinois = 4;  // methods of task 11.4

// TASK 11.1 (3 points): how many steps a march takes. Do not round, so that no line shows where the number changes. By
// angle: `max_steps` where the ray is level (slant 0), `min_steps` where it looks straight down (slant 1), linear in
// between. By texel: one step for every `texels_per_step` texels of the march's length, counted on the level that is
// read, but at least 1 and at most 1024. `size` is that of level 0; a texel of level k is 2^k times as wide.
float steps_by_angle(float slant, float min_steps, float max_steps) {
    //[solution
    return mix(max_steps, min_steps, slant);
    //]starter
    //| return unfinished(8.0);
    //]
}

float steps_by_texel(ReliefRay ray, vec2 size, float texels_per_step) {
    //[solution
    float texels = length(ray.march * size) * exp2(-ray.level);
    return clamp(texels / texels_per_step, 1.0, 1024.0);
    //]starter
    //| return unfinished(8.0);
    //]
}

// TASK 11.2 (4 points): the march. gap() returns how far the ray runs above the surface at t: read level ray.level of
// the map by textureLod, since neighbouring pixels are at other iterations. march() looks at t = 0, then goes on by 1
// / steps until the ray is no longer above the surface, and returns the last two points. `steps` may have a fraction:
// then the last step is shorter, since t never passes 1.
float gap(sampler2D heights, ReliefRay ray, float t) {
    //[solution
    return 1.0 - t - textureLod(heights, ray.uv + t * ray.march, ray.level).r;
    //]starter
    //| return unfinished(0.0);
    //]
}

//(march
Bracket march(sampler2D heights, ReliefRay ray, float steps) {
    //[solution
    float stride = 1.0 / max(steps, 1.0), above = gap(heights, ray, 0.0);
    Bracket b = Bracket(0.0, 0.0, above, above);
    while (b.gap_after > 0.0 && b.after < 1.0) {
        b.before = b.after;
        b.gap_before = b.gap_after;
        b.after = min(b.after + stride, 1.0);
        b.gap_after = gap(heights, ray, b.after);
    }
    return b;
    //]starter
    //| return Bracket(0.0, unfinished(1.0), 1.0, -1.0);
    //]
}
//)

// TASK 11.3 (3 points): between two points the ray's height goes from b to b + db, and the surface's from h to h + dh,
// assumed straight. They meet at the share x of the way: x = (h - b) / (db - dh). Write it with the gaps, b - h at
// either end. Where both gaps are 0 the lines meet everywhere: any x from 0 to 1 is right, but it must not be NaN.
//(crossing
float crossing(float gap_before, float gap_after) {
    //[solution
    float closing = gap_before - gap_after;
    return closing > 0.0 ? gap_before / closing : 0.0;
    //]starter
    //| return unfinished(0.5);
    //]
}
//)

// TASK 11.4 (3 points): `rounds` times, look at one point within the bracket and make it one of the ends, so that the
// ray still goes below the surface between them. Bisection takes the point in the middle, secant the point where the
// lines of 11.3 cross. Illinois: like secant, with a weight for the gap of each end. The weight is 1. Each time that an
// end is kept for the second round in a row or a later one, its weight is halved: 1/2, 1/4, ... It is 1 again once the
// end is replaced. That draws the point to the end that stays, which otherwise might stay forever. Only the weight is
// halved: the bracket that you return has the full gaps.
Bracket refined(sampler2D heights, ReliefRay ray, Bracket b, int rounds, int method) {
    //[solution
    vec2 weight = vec2(1.0);
    int stayed = 0;  // 1: the end after, -1: the end before
    for (int i = 0; i < rounds && b.gap_before > 0.0; ++i) {
        float x = method == bisection ? 0.5 : crossing(weight.x * b.gap_before, weight.y * b.gap_after);
        float t = mix(b.before, b.after, x), above = gap(heights, ray, t);
        if (above > 0.0) {
            b.before = t;
            b.gap_before = above;
            weight = vec2(1.0, method == illinois && stayed == 1 ? 0.5 * weight.y : 1.0);
            stayed = 1;
        } else {
            b.after = t;
            b.gap_after = above;
            weight = vec2(method == illinois && stayed == -1 ? 0.5 * weight.x : 1.0, 1.0);
            stayed = -1;
        }
    }
    return b;
    //]starter
    //| b.after = unfinished(b.after);
    //| return b;
    //]
}

// TASK 11.5 (2 points): a pixel now has two coordinates. on_surface() reads a map of the surface: at the point where
// the ray ended, but with the mip level of the original coordinate (dFdx, dFdy, textureGrad), since the displaced one
// jumps from one bump to another between two pixels. above_surface() returns the coordinate of a pane above the
// relief, at height 1.
vec4 on_surface(sampler2D map, vec2 original, vec2 displaced) {
    //[solution
    return textureGrad(map, displaced, dFdx(original), dFdy(original));
    //]starter
    //| return unfinished(vec4(0.5));
    //]
}

vec2 above_surface(vec2 original, vec2 displaced) {
    //[solution
    return original;
    //]starter
    //| return unfinished(displaced);
    //]
}
