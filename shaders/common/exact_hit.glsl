// The exact first hit of a view ray and a relief. Pictures compare their method with it.

#include "common/cell_walk.glsl"
#include "common/height_cell.glsl"

// How the search reads a cell. A shader that counts the reads defines another function before it includes this file.
#ifndef READ_CELL
#define READ_CELL cell_corners
#endif

// Returns the first t in [between.x, between.y] at which the ray is on or below the bilinear surface. Returns between.y
// if there is none, or if max_iterations are not enough. The ray goes from `uv` at height 1, t = 0, to uv + along at
// height 0, t = 1. The search walks from cell to cell (Amanatides and Woo 1987).
//[solution
// It skips cells that lie below the ray: `windows` and `extent` are height_windows() of the heights. The students'
// version skips nothing, because skipping is the task of lab 12.
//]starter
//| // It skips nothing, so `windows` and `extent` are not read: skipping is the task of lab 12.
//]
float exact_hit(sampler2D heights, sampler2DArray windows, mat4 extent, vec2 uv, vec2 along, vec2 between) {
    vec2 size = vec2(textureSize(heights, 0)), from = fract(uv) * size - 0.5, march = along * size;
    int last = iterations_between(march, between.x, between.y);
    //[solution
    vec2 first = floor(from), start = from - first, texel = 1.0 / size;
    vec2 block = size / vec2(textureSize(windows, 0).xy), per_block = 1.0 / block;
    vec2 way = way_of(march), per_cell = 1.0 / max(abs(march), vec2(1e-9));
    vec2 ahead = start_along(start, way), passed = floor(ahead + between.x * abs(march));
    vec2 first_ahead = mix(-first - 1.0, first, greaterThan(way, vec2(0.0)));
    float octant = octant_of(march, way), t = between.x;
    int axis = octant < 4.0 ? 0 : 2;
    vec4 beyond_u = extent[axis] * per_cell.x, beyond_v = extent[axis + 1] * per_cell.y;
    for (int i = 0; i < last && t < between.y; ++i) {
        vec2 cell = way * passed, place = first + cell, leaves = (passed + 1.0 - ahead) * per_cell;
        float end = clamp(min(leaves.x, leaves.y), t, between.y);
        vec3 gap = gap_above_cell(READ_CELL(heights, ivec2(place)), vec3(start + t * march - cell, 1.0 - t),
                                  vec3(start + end * march - cell, 1.0 - end));
        if (closes(gap)) return mix(t, end, first_closing(gap));
        vec2 block_ends = (floor((first_ahead + passed) * per_block) + 1.0) * block - first_ahead;
        vec2 leaves_block = (block_ends - ahead) * per_cell;
        vec4 clearance = textureLod(windows, vec3((place + 0.5) * texel, octant), 0.0);
        vec4 safe = min(min(leaves_block.x + beyond_u, leaves_block.y + beyond_v), clearance);
        t = max(max(end, max(safe.x, safe.y)), max(safe.z, safe.w));
        passed = next_cell(passed, leaves, ahead + t * abs(march));
    }
    return between.y;
    //]starter
    //| vec2 first = floor(from), start = from - first;
    //| vec2 way = way_of(march), per_cell = 1.0 / max(abs(march), vec2(1e-9));
    //| vec2 ahead = start_along(start, way), passed = floor(ahead + between.x * abs(march));
    //| float t = between.x;
    //| for (int i = 0; i < last && t < between.y; ++i) {
    //|     vec2 cell = way * passed, leaves = (passed + 1.0 - ahead) * per_cell;
    //|     float end = clamp(min(leaves.x, leaves.y), t, between.y);
    //|     vec3 gap = gap_above_cell(READ_CELL(heights, ivec2(first + cell)),
    //|                               vec3(start + t * march - cell, 1.0 - t), vec3(start + end * march - cell, 1.0 - end));
    //|     if (closes(gap)) return mix(t, end, first_closing(gap));
    //|     passed = next_cell(passed, leaves, ahead + end * abs(march));
    //|     t = end;
    //| }
    //| return between.y;
    //]
}
