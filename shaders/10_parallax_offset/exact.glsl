// Where the view ray really meets the relief: what the guesses are held against in the picture.

#include "common/height_cell.glsl"

// The first t in [0, 1] at which a ray that goes from uv at height 1 by `along` to height 0 is not above the bilinear surface:
// from cell to cell (Amanatides and Woo 1987), and further at once where it runs above all that is near. For each block of
// cells `tops` has the highest height in it, and in it and the 1, 3 and 8 blocks around. 1 after `most` turns.
float exact_t(sampler2D heights, sampler2D tops, vec2 uv, vec2 along, int most) {
    vec2 size = vec2(textureSize(heights, 0)), blocks = vec2(textureSize(tops, 0)), block_size = size / blocks;
    vec2 from = fract(uv) * size - 0.5, march = along * size;
    vec2 way = mix(vec2(-1.0), vec2(1.0), greaterThanEqual(march, vec2(0.0))), ahead = max(way, 0.0);
    vec2 slowness = way / max(abs(march), vec2(1e-9));
    float t = 0.0;
    for (int i = 0; i < most && t < 1.0; ++i) {
        vec2 here = from + t * march;
        vec2 inside = here + (i > 0 ? 1e-6 : 0.0) * way * size;  // on a line between two cells, the one that is entered
        vec2 cell = floor(inside), block = floor(inside / block_size);
        vec2 leaves = (cell + ahead - from) * slowness, leaves_block = ((block + ahead) * block_size - from) * slowness;
        float end = clamp(min(leaves.x, leaves.y), t, 1.0);
        vec3 gap = gap_above_cell(cell_corners(heights, ivec2(cell)), vec3(here - cell, 1.0 - t),
                                  vec3(from + end * march - cell, 1.0 - end));
        if (closes(gap)) return mix(t, end, first_closing(gap));
        vec4 top = texelFetch(tops, ivec2(block - blocks * floor(block / blocks)), 0);
        vec2 passes_block = block_size * abs(slowness);
        const vec4 around = vec4(0.0, 1.0, 3.0, 8.0);
        vec4 safe = min(min(leaves_block.x + around * passes_block.x, leaves_block.y + around * passes_block.y), 1.0 - top);
        t = max(max(end, max(safe.x, safe.y)), max(safe.z, safe.w));
    }
    return 1.0;
}
