// Skips squares of 2, 4, 8 and 16 cells. After a square that the ray passes over it tries a larger one, and otherwise a
// smaller one (after Tevs, Ihrke and Seidel 2008).

uniform sampler2D s_bounds;  // minimum and maximum of 2^k x 2^k cells, see min_max_atlas()
uniform int u_top_level;

int level = 0;

float next_t(Look at) {
    ivec2 size = textureSize(s_heights, 0);
    ivec2 corner = level == 0 ? ivec2(0) : ivec2(size.x, size.y - (size.y >> (level - 1)));
    float side = exp2(float(level));
    vec2 square = floor((at.first + at.cell) / side);
    vec2 out_of_square = leave_square(at.ray, at.inverse, square * side - at.first, side);
    float highest = texelFetch(s_bounds, corner + ivec2(mod(square, vec2(size) / side)), 0).g;
    float leaves = min(out_of_square.x, out_of_square.y), above = above_until(at, vec4(1.0 - highest)).x;
    level = clamp(level + (above >= leaves ? 1 : -1), min(1, u_top_level), u_top_level);
    return max(at.leaves, min(leaves, above));
}
