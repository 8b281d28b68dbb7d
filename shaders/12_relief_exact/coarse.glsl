// Skips two cells at a time, as long as the ray is above all of the 5 x 5 cells around it.

uniform sampler2D s_around;  // maximum of 5 x 5 cells

float next_t(Look at) {
    vec2 size = vec2(textureSize(s_heights, 0));
    float highest = texelFetch(s_around, ivec2(mod(at.first + at.cell, size)), 0).r;
    float above = above_until(at, vec4(1.0 - highest)).x;
    return max(at.leaves, min(at.t + 2.0 * min(at.per_cell.x, at.per_cell.y), above));
}
