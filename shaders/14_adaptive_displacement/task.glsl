// Lab 14, yours: how finely the edges of a patch are cut, which patches are not drawn, and where displacement fades away.

#include "common/unfinished.glsl"

// TASK 14.1 (3 points): the level of an edge by distance: 2^finest where the middle of the edge from a to b is `nearest` metres
// from the eye, or nearer; 2^coarsest where it is `farthest` metres, or farther; in between the exponent is a straight line
// over the distance. The patch on the other side of the edge has a and b the other way round, and must get the very same
// bits: so nothing may depend on which end is which. `precise` keeps a compiler from fusing a product with one sum and not
// with another.
float level_by_distance(vec3 a, vec3 b, vec3 eye, float nearest, float farthest, float finest, float coarsest) {
    //[solution
    precise float share = clamp((distance(0.5 * (a + b), eye) - nearest) / (farthest - nearest), 0.0, 1.0);
    precise float level = exp2(mix(finest, coarsest, share));
    return level;
    //]starter
    //| return unfinished(4.0);
    //]
}

// TASK 14.2 (3 points): by size. Take the edge as the diameter of a sphere around its middle: so many pixels has that on the
// screen, and one segment may have `pixels_per_segment` of them. What is seen under an angle of one radian has
// `pixels_per_radian` pixels. Unlike the edge's own length on the screen, this does not shrink when the edge turns towards
// the eye. level_by_size() gives what possible_level() makes of that: it keeps a level within 1 and 64, which is what the
// tessellator can do, and makes 1 of one that is not a number: level 0 would cull the whole patch, and so an edge without
// length would.
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

// TASK 14.3 (4 points): by error. tolerated() says how far a height in [0, 1] may be off where the screen may show `budget`
// pixels of it: the relief is `scale` metres deep and `distance_` metres away; one without depth tolerates anything, 1e30.
// How far heights are off at the levels 1, 2, 4, 8 (coarse) and 16, 32, 64 (the first three of fine) is known, and never rises.
// level_by_error() is the least level whose error is tolerated, 64 where none is; between two levels the error is a straight
// line over the exponent of 2.
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

// TASK 14.4 (3 points): the edges' levels in the order of gl_TessLevelOuter. Edge i goes from corner i to the next. The corners
// of a triangle are where gl_TessCoord is (1, 0, 0), (0, 1, 0) and (0, 0, 1), and level 0 is that of the edge where its first
// is 0; those of a quad are at (0, 0), (1, 0), (1, 1) and (0, 1), and levels 0 to 3 are those of u = 0, v = 0, u = 1, v = 1.
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

// TASK 14.5 (4 points): what is not in the picture. A flat patch lies within a sphere (centre, radius). Each of its places is
// moved by scale (h - 1), h from `lowest` to `highest`, along a unit vector whose difference from the unit vector `axis` is
// `spread` long at most. relief_bounds() is a sphere around all that can come of it: its centre moves along the axis to the
// middle of the relief, and its radius grows by half of what lies between lowest and highest, and by what `spread` can do to
// the longest way, that of the lowest height. is_outside() says whether a sphere is wholly behind one of six planes; xyz is unit and points into the
// picture, dot(plane.xyz, p) + plane.w is how far p is in front of it.
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

// TASK 14.6 (3 points): what only shows its back. All triangles of a patch have normals within an angle of `axis` (unit) whose tangent
// is `slope`, and lie in a sphere; lines of sight to it differ by an angle from the one to its centre, too. The patch faces
// away when even both angles together leave less than 90 degrees between a normal and the way that a line of sight goes on.
// It never does while the eye is in the sphere, where the sphere has no angle.
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

// TASK 14.7 (2 points): how much of the displacement is left at a distance: all of it up to `begin`, nothing from `end` on, a
// straight line in between; `begin` is less than `end`. It is taken at the undisplaced place of a vertex: two patches that share it know it alike.
float remaining(float distance_, float begin, float end) {
    //[solution
    return clamp((end - distance_) / (end - begin), 0.0, 1.0);
    //]starter
    //| return unfinished(1.0);
    //]
}
