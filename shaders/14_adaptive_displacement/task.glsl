// Lab 14, your tasks: the levels of a patch's edges, which patches to cull, and where displacement fades out.

#include "common/unfinished.glsl"

// TASK 14.1 (3 points): the level of an edge by distance: 2^finest if the middle of the edge from a to b is `nearest`
// metres from the eye, or nearer; 2^coarsest if it is `farthest` metres away, or farther; in between, interpolate the
// exponent linearly over the distance. The patch on the other side of the edge has a and b exchanged, and must get the
// same level bit for bit: so the result may not depend on which end is which. `precise` prevents a compiler from
// fusing a product with one sum and not with another.
float level_by_distance(vec3 a, vec3 b, vec3 eye, float nearest, float farthest, float finest, float coarsest) {
    //[solution
    precise float share = clamp((distance(0.5 * (a + b), eye) - nearest) / (farthest - nearest), 0.0, 1.0);
    precise float level = exp2(mix(finest, coarsest, share));
    return level;
    //]starter
    //| return unfinished(4.0);
    //]
}

// TASK 14.2 (3 points): the level by size. Take the edge as the diameter of a sphere around its middle. How many
// pixels does that cover on the screen? One segment may have `pixels_per_segment` of them. An angle of one radian
// covers `pixels_per_radian` pixels. Unlike the edge's own length on the screen, the diameter does not shrink when the
// edge turns towards the eye. level_by_size() returns possible_level() of that. possible_level() clamps a level to 1
// and 64, the limits of the tessellator, and returns 1 for NaN: level 0 would cull the whole patch, and an edge
// without length would have level 0.
float possible_level(float level) {
    //[solution
    return level > 1.0 ? min(level, 64.0) : 1.0;
    //]starter
    //| return unfinished(4.0);
    //]
}

float level_by_size(vec3 a, vec3 b, vec3 eye, float pixels_per_radian, float pixels_per_segment) {
    //[solution
    precise float pixels = distance(a, b) * pixels_per_radian / distance(0.5 * (a + b), eye);
    return possible_level(pixels / pixels_per_segment);
    //]starter
    //| return unfinished(4.0);
    //]
}

// TASK 14.3 (4 points): the level by error. tolerated() returns by how much a height in [0, 1] may be off if the error
// on the screen may be `budget` pixels: the relief is `scale` metres deep and `distance_` metres away. A relief
// without depth tolerates any error: return 1e30. The errors of the heights at the levels 1, 2, 4, 8 (coarse) and 16,
// 32, 64 (the first three of fine) are known, and never rise. level_by_error() returns the lowest level whose error is
// tolerated, or 64 if there is none; between two levels the error is interpolated linearly over the exponent of 2.
float tolerated(float distance_, float pixels_per_radian, float budget, float scale) {
    //[solution
    return scale > 0.0 ? budget * distance_ / (pixels_per_radian * scale) : 1e30;
    //]starter
    //| return unfinished(1.0);
    //]
}

//(by-error
float level_by_error(vec4 coarse, vec4 fine, float tolerance) {
    //[solution
    float errors[7] = float[](coarse.x, coarse.y, coarse.z, coarse.w, fine.x, fine.y, fine.z);
    int octave = 0;
    while (octave < 6 && errors[octave] > tolerance) ++octave;
    if (octave == 0 || !(errors[octave] <= tolerance)) return exp2(float(octave));
    precise float share = (errors[octave - 1] - tolerance) / (errors[octave - 1] - errors[octave]);
    return exp2(float(octave - 1) + share);
    //]starter
    //| return unfinished(4.0);
    //]
}
//)

// TASK 14.4 (3 points): the levels of the edges in the order of gl_TessLevelOuter. Edge i goes from corner i to the
// next. The corners of a triangle are where gl_TessCoord is (1, 0, 0), (0, 1, 0) and (0, 0, 1), and outer level 0
// belongs to the edge where its first coordinate is 0. The corners of a quad are at (0, 0), (1, 0), (1, 1) and (0, 1),
// and outer levels 0 to 3 belong to u = 0, v = 0, u = 1, v = 1.
vec4 outer_levels_of_triangle(vec3 edges) {
    //[solution
    return vec4(edges.yzx, 0.0);
    //]starter
    //| return unfinished(vec4(edges, 0.0));
    //]
}

vec4 outer_levels_of_quad(vec4 edges) {
    //[solution
    return edges.wxyz;
    //]starter
    //| return unfinished(edges);
    //]
}

// TASK 14.5 (4 points): cull what is outside of the picture. A flat patch lies within a sphere (centre, radius). Each
// of its points is moved by scale (h - 1), with h from `lowest` to `highest`, along a vector of unit length that
// differs from `axis` (also of unit length) by a vector of length `spread` at most. relief_bounds() returns a sphere
// around every possible result: its centre moves along the axis to the middle of the relief. Its radius grows by half
// of the thickness between lowest and highest, and by `spread` times the longest way, that of the lowest height.
// is_outside() returns whether a sphere is wholly behind one of six planes; xyz of a plane has unit length and points
// into the picture, and dot(plane.xyz, p) + plane.w is the distance of p in front of it.
vec4 relief_bounds(vec4 flat_, vec3 axis, float spread, float lowest, float highest, float scale) {
    //[solution
    float low = scale * (lowest - 1.0), high = scale * (highest - 1.0);
    return vec4(flat_.xyz + 0.5 * (low + high) * axis,
                flat_.w + 0.5 * (high - low) + max(abs(low), abs(high)) * spread);
    //]starter
    //| return unfinished(flat_);
    //]
}

bool is_outside(vec4 planes[6], vec4 sphere) {
    //[solution
    for (int i = 0; i < 6; ++i)
        if (dot(planes[i].xyz, sphere.xyz) + planes[i].w < -sphere.w) return true;
    return false;
    //]starter
    //| return unfinished(0.0) > 0.0;
    //]
}

// TASK 14.6 (3 points): cull what faces away. The normals of all triangles of a patch are within an angle of `axis`
// (of unit length) whose tangent is `slope`, and the triangles lie in a sphere: lines of sight to it also differ by an
// angle from the one to its centre. The patch faces away if, even with both angles added, the angle between a normal
// and the direction of a line of sight is less than 90 degrees. It never does if the eye is in the sphere, where the
// sphere has no angle.
//(faces-away
bool faces_away(vec3 axis, float slope, vec4 sphere, vec3 eye) {
    //[solution
    vec3 away = sphere.xyz - eye;
    float distance_ = length(away);
    if (!(distance_ > sphere.w)) return false;
    float angle = atan(slope) + asin(sphere.w / distance_);
    return angle < radians(90.0) && dot(axis, away) > sin(angle) * distance_;
    //]starter
    //| return unfinished(0.0) > 0.0;
    //]
}
//)

// TASK 14.7 (2 points): how much of the displacement is left at a distance: all of it up to `begin`, none from `end`
// on, linear in between; `begin` is less than `end`. The distance is that of a vertex's undisplaced position, so two
// patches that share the vertex get the same bits.
float remaining(float distance_, float begin, float end) {
    //[solution
    return clamp((end - distance_) / (end - begin), 0.0, 1.0);
    //]starter
    //| return unfinished(1.0);
    //]
}
