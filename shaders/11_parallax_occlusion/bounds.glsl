// Minimum and maximum heights of the map. A texel of level k bounds 2^k x 2^k cells.

// All levels are in one texture: level 0 on the left, the others above each other to its right. Mip levels would not
// do: a renderer may fetch the same level for four neighbouring pixels, which need different ones.
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
