// Lab 03, your tasks: slopes, and their normals.

#include "common/unfinished.glsl"

// TASK 3.1 (3 points): Sobel's filter. h holds a texel and its eight neighbours, row by row from below, each row from
// left to right: h[0] is below and to the left, h[4] the texel itself, h[7] above it. The slope along u is the central
// difference (right minus left, divided by two texels), averaged over the three rows with the weights 1 2 1. Likewise
// along v.
//(sobel
vec2 sobel(float h[9]) {
    //[solution
    float right = h[2] + 2.0 * h[5] + h[8], left = h[0] + 2.0 * h[3] + h[6];
    float above = h[6] + 2.0 * h[7] + h[8], below = h[0] + 2.0 * h[1] + h[2];
    return vec2(right - left, above - below) / 8.0;
    //]starter
    //| return unfinished(vec2(0.0));
    //]
}
//)

// TASK 3.2 (3 points): the normal, of unit length. `slope` is dh/du and dh/dv per texel, for heights in [0, 1]. A
// height of 1 is `texels.x` texels along u and `texels.y` along v (they differ where texels are not square): twice the
// texels, twice the slope. A surface that rises to the right leans to the left.
//(normal
vec3 normal_of_slope(vec2 slope, vec2 texels) {
    //[solution
    return normalize(vec3(-slope * texels, 1.0));
    //]starter
    //| return unfinished(vec3(0.0, 0.0, 1.0));
    //]
}
//)

// TASK 3.3 (3 points): a height from a colour. You may add light, but not stored values: decode the colour to light,
// add red, green and blue with the weights 0.2126, 0.7152 and 0.0722, and encode the grey as sRGB again.
float linear_of(float stored) { return stored <= 0.04045 ? stored / 12.92 : pow((stored + 0.055) / 1.055, 2.4); }
float stored_of(float light) { return light <= 0.0031308 ? light * 12.92 : 1.055 * pow(light, 1.0 / 2.4) - 0.055; }

float height_of_color(vec3 color) {
    //[solution
    vec3 light = vec3(linear_of(color.r), linear_of(color.g), linear_of(color.b));
    return stored_of(dot(light, vec3(0.2126, 0.7152, 0.0722)));
    //]starter
    //| return unfinished(0.0);
    //]
}
