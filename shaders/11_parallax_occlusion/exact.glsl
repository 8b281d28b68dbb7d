// Where a ray really meets the relief, to hold the march against: slow, and for the error view alone.

#include "common/height_cell.glsl"

uniform int u_most_cells;

const int block_level = 3;  // of the bounds: eight by eight cells

// From cell to cell (Amanatides and Woo 1987), each solved for its first root; past a whole block where the ray stays above
// all of it. t = 1 where nothing is met.
float exact_hit(sampler2D heights, vec2 uv, vec2 march) {
    vec2 size = vec2(textureSize(heights, 0)), along = march * size, ahead = step(0.0, along);
    int level = min(block_level, highest_level(heights));
    vec2 blocks = vec2(bounds_size(heights, level)), block_size = size / blocks;
    vec2 from = fract(uv) * size - 0.5, cell = floor(from);
    vec2 slowness = mix(1.0 / along, vec2(1e30), lessThan(abs(along), vec2(1e-20)));
    float t = 0.0;
    for (int i = 0; i < u_most_cells; ++i) {
        // To the lines ahead, each from the entry: nothing adds up.
        vec2 lines = abs((cell + ahead - from) * slowness);
        float next = clamp(min(lines.x, lines.y), t, 1.0);
        vec3 gaps = gap_above_cell(cell_corners(heights, ivec2(cell)), vec3(from + t * along - cell, 1.0 - t),
                                   vec3(from + next * along - cell, 1.0 - next));
        if (closes(gaps)) return mix(t, next, first_closing(gaps));
        vec2 block = floor((cell + 0.5) / block_size);
        vec2 ends = abs((block * block_size + ahead * block_size - from) * slowness);
        float past = clamp(min(ends.x, ends.y), next, 1.0);
        float top = bounds_at(heights, ivec2(mod(block, blocks)), level).g;
        bool clear = 1.0 - past > top;
        t = clear ? past : next;
        if (t >= 1.0) return 1.0;
        vec2 over = clear ? ends : lines;
        // Along the axis that is crossed the next cell is known; along the other it is wherever the ray is.
        vec2 crossed = over.x <= over.y ? vec2(1.0, 0.0) : vec2(0.0, 1.0);
        vec2 edge = clear ? (block + ahead) * block_size : cell + ahead;
        cell = mix(clear ? floor(from + t * along) : cell, edge + ahead - 1.0, crossed);
    }
    return 1.0;
}
