// The lowest and the highest height of each region of the map, level by level: 2^k x 2^k cells are one texel of level k.

// All levels in one texture, level 0 on the left and the others one above the other beside it: four neighbouring pixels
// may want different ones, and of a texture's own levels a renderer may fetch the same for all four.
uniform sampler2D s_bounds;

int highest_level(sampler2D heights) {
    ivec2 size = textureSize(heights, 0);
    return findMSB(max(size.x, size.y));
}

ivec2 bounds_size(sampler2D heights, int level) { return max(textureSize(heights, 0) >> level, ivec2(1)); }

vec2 bounds_at(sampler2D heights, ivec2 texel, int level) {
    ivec2 size = textureSize(heights, 0);
    ivec2 corner = level == 0 ? ivec2(0) : ivec2(size.x, size.y - (size.y >> (level - 1)));
    return texelFetch(s_bounds, corner + texel, 0).rg;
}
