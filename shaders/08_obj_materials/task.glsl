// Lab 08, your tasks: glass, masks, a lamp, and a highlight from a map. (Tasks 8.1 and 8.2 are in
// labs/08_obj_materials/task.cpp.)

#include "common/unfinished.glsl"

// TASK 8.3 (2 points): a pane of glass sends `light` and covers the share `opacity` of what lies behind it. The
// result is premultiplied: the light that is added, and in the fourth channel the share that it covers. (The lab has
// set glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA); target and light are linear.)
//(over
vec4 over(vec3 light, float opacity) {
    //[solution
    return vec4(light * opacity, opacity);
    //]starter
    //| return unfinished(vec4(light, opacity));
    //]
}
//)

// TASK 8.4 (4 points): how much of a pixel does a masked surface cover? `alpha` is the mask at the pixel, and
// `change` is how much it changes from this pixel to the next. The edge of the surface is where scale * alpha is 1/2;
// `scale` belongs to the mip level, and keeps as much of the mask above 1/2 as on level 0 (1 there). The edge is to
// be one pixel wide: over it the share grows evenly from 0 to 1, and is 1/2 on the edge itself. A change below 1/256
// counts as 1/256.
//(covered
float covered(float alpha, float change, float scale) {
    //[solution
    return clamp((scale * alpha - 0.5) / max(scale * change, 1.0 / 256.0) + 0.5, 0.0, 1.0);
    //]starter
    //| return unfinished(alpha);
    //]
}
//)

// TASK 8.5 (3 points): the share of a lamp's light that reaches a place. `from_lamp` (metres) leads from the lamp to
// the place. The light falls off as 1 / (a.x + a.y d + a.z d^2) with the distance d, and is 0 from `range` on. Off
// the axis (of unit length, the way the lamp shines) it falls as the cosine to the power of `cone`, and behind the
// lamp it is 0; with a cone of 0 it shines alike in all directions. At the lamp itself the share is 1 / a.x (a.x is
// above 0).
//(spot
float spot(vec3 from_lamp, vec3 axis, float range, float cone, vec3 a) {
    //[solution
    float d = length(from_lamp);
    if (d >= range) return 0.0;
    float share = 1.0 / (a.x + d * (a.y + d * a.z));
    if (cone <= 0.0 || d == 0.0) return share;
    float cosine = dot(from_lamp, axis) / d;
    return cosine > 0.0 ? share * pow(cosine, cone) : 0.0;
    //]starter
    //| return unfinished(0.3);
    //]
}
//)

// TASK 8.6 (3 points): the highlight that a texel of map_Ks stands for: its colour, and in the fourth channel the
// exponent. The map stores the exponent / 256 there; an exponent is at least 1.
//(specular
vec4 specular_of(vec4 texel) {
    //[solution
    return vec4(texel.rgb, max(texel.a * 256.0, 1.0));
    //]starter
    //| return unfinished(vec4(0.0, 0.0, 0.0, 1.0));
    //]
}
//)
