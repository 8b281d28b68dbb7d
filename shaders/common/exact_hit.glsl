// The exact first hit of a view ray and a relief: a picture compares its method with it.

#include "common/height_cell.glsl"

// A ray goes from `uv` at height 1, t = 0, to uv + along at height 0, t = 1. The first t from between.x to between.y at
// which it is not above the bilinear surface: from cell to cell (Amanatides and Woo 1987).
//[solution
// And at once past what lies below it: `windows` and `grown` are height_windows() of the heights. Students get a walk that
// skips nothing, as how to skip is what lab 12 asks for.
//]starter
//| // It skips nothing, so `windows` and `grown` are not read: how to skip is for lab 12.
//]
// between.y where there is none, or not in `most` turns.
float exact_hit(sampler2D heights, sampler2D windows, vec4 grown, vec2 uv, vec2 along, vec2 between, int most) {
    vec2 size = vec2(textureSize(heights, 0)), from = fract(uv) * size - 0.5, march = along * size;
    //[solution
    ivec2 blocks = textureSize(windows, 0) / ivec2(4, 1);  // the quadrants stand side by side
    vec2 block_size = size / vec2(blocks);
    vec2 way = mix(vec2(-1.0), vec2(1.0), greaterThanEqual(march, vec2(0.0))), ahead = max(way, 0.0);
    vec2 slowness = way / max(abs(march), vec2(1e-9)), per_cell = abs(slowness);
    int quadrant = (way.x < 0.0 ? 1 : 0) + (way.y < 0.0 ? 2 : 0);
    float t = between.x;
    for (int i = 0; i < most && t < between.y; ++i) {
        // On a line between two cells, the one that is entered.
        vec2 here = from + t * march, inside = here + 1e-6 * way * size;
        vec2 cell = floor(inside), block = floor(inside / block_size);
        vec2 leaves = (cell + ahead - from) * slowness, leaves_block = ((block + ahead) * block_size - from) * slowness;
        float end = clamp(min(leaves.x, leaves.y), t, between.y);
        vec3 gap = gap_above_cell(cell_corners(heights, ivec2(cell)), vec3(here - cell, 1.0 - t),
                                  vec3(from + end * march - cell, 1.0 - end));
        if (closes(gap)) return mix(t, end, first_closing(gap));
        ivec2 place = ivec2(mod(block, vec2(blocks))) + ivec2(quadrant * blocks.x, 0);
        vec4 safe = min(min(leaves_block.x + grown * per_cell.x, leaves_block.y + grown * per_cell.y),
                        texelFetch(windows, place, 0));
        t = max(max(end, max(safe.x, safe.y)), max(safe.z, safe.w));
    }
    return between.y;
    //]starter
    //| vec2 way = mix(vec2(-1.0), vec2(1.0), greaterThanEqual(march, vec2(0.0)));
    //| vec2 per_cell = 1.0 / max(abs(march), vec2(1e-9)), begin = from + between.x * march;
    //| vec2 first = abs(max(way, 0.0) - fract(begin)), passed = vec2(0.0);  // walls ahead, in texels, and behind
    //| float t = between.x;
    //| for (int i = 0; i < most && t < between.y; ++i) {
    //|     vec2 cell = floor(begin) + way * passed, next = between.x + (first + passed) * per_cell;
    //|     float end = min(min(next.x, next.y), between.y);
    //|     vec3 gap = gap_above_cell(cell_corners(heights, ivec2(cell)), vec3(from + t * march - cell, 1.0 - t),
    //|                               vec3(from + end * march - cell, 1.0 - end));
    //|     if (closes(gap)) return mix(t, end, first_closing(gap));
    //|     passed += vec2(lessThanEqual(next, vec2(end)));
    //|     t = end;
    //| }
    //| return between.y;
    //]
}
