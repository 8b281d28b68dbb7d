// The first hit of a ray and a height map, exactly: six ways to skip what cannot be hit, one test of what can.
//
// Every turn of the loop looks at one cell, the bilinear surface between four texel centres, and then goes on to a place
// that the ray reaches without a hit: at least to the next cell. So the ways differ in their number of turns and in what
// a turn costs, and not in their result.

#include "common/height_cell.glsl"
#include "12_relief_exact/task.glsl"

uniform sampler2D s_heights;
uniform float u_highest;   // of all heights
uniform int u_most_turns;  // no ray gets more; where it is not enough, the ray stops where it is
uniform vec4 u_grown;      // cells that window k reaches beyond the block (or the cell) that it belongs to
uniform int u_block_shift;        // log2 of the cells along a block's side
uniform sampler2D s_windows;      // a texel a block: for each of four windows, 1 - its highest height
uniform isampler2DArray s_cells;  // a texel a cell: its corners and its windows, see cell_map()
uniform sampler2D s_around;       // the highest in 5 x 5 cells
uniform sampler2D s_bounds;       // the lowest and the highest in 2^k x 2^k cells, see min_max_atlas()
uniform int u_top_level;
uniform sampler2D s_cones;        // over a cell's highest corner, texels of free radius per unit of height

struct ReliefHit {
    float t;
    bool missed;  // came to the ray's end
    int turns;
};

vec2 never_zero(vec2 v) {
    return vec2(abs(v.x) < 1e-9 ? 1e-9 : v.x, abs(v.y) < 1e-9 ? 1e-9 : v.y);
}

float height_of(ReliefRay ray, float t) {
    return ray.height.x + t * (ray.height.y + t * ray.height.z);
}

float lowest_between(ReliefRay ray, float t0, float t1) {
    float bottom = -ray.height.y / (2.0 * max(ray.height.z, 1e-20));
    return height_of(ray, clamp(bottom, t0, t1));
}

// gap_above_cell() for a ray that may bend: its middle coefficient is the blossom of both. The corners may be in any unit,
// as long as the ray's height is in the same.
vec3 gap_between(vec4 corners, ReliefRay ray, float t0, float t1, vec2 cell) {
    vec2 a = ray.start + t0 * ray.along - cell, b = ray.start + t1 * ray.along - cell;
    float along_u = corners.z - corners.w, along_v = corners.x - corners.w;
    float twist = corners.y - corners.x - along_u;
    vec4 u = vec4(a.x, b.x, a.x, b.x), v = vec4(a.y, a.y, b.y, b.y);  // the square that the two ends span
    vec4 heights = corners.w + along_u * u + v * (along_v + twist * u);
    float middle = ray.height.x + 0.5 * (ray.height.y * (t0 + t1) - heights.y - heights.z) + ray.height.z * t0 * t1;
    return vec3(height_of(ray, t0) - heights.x, middle, height_of(ray, t1) - heights.w);
}

// Until which t the ray stays above 1 - clear. A ray that bends runs above its tangent, so that is never too late; the
// view ray on a flat base (`plain`) is 1 - t high.
vec4 above_until(ReliefRay ray, bool plain, float t, vec4 clear) {
    if (plain) return clear;
    float falls = -(ray.height.y + 2.0 * t * ray.height.z);
    return t + (height_of(ray, t) - 1.0 + clear) / max(falls, 1e-9);
}

// From t to t_end; at t the ray is not below the surface.
ReliefHit first_hit(ReliefRay ray, bool plain, float t, float t_end) {
    vec2 size = vec2(textureSize(s_heights, 0)), texel = 1.0 / size;
    ivec2 last = textureSize(s_heights, 0) - 1;
    ray.start = mod(ray.start, size);  // near the origin a float has digits to spare
    vec2 along = never_zero(ray.along), inverse = 1.0 / along, per_cell = abs(inverse);
    vec2 nudge = sign(along) * 1e-6 * size;  // out of the cell behind
    int quadrant = (along.x < 0.0 ? 1 : 0) + (along.y < 0.0 ? 2 : 0);
    ReliefRay scaled = ray;
#ifdef CELLS
    scaled.height *= 2147483392.0;  // the unit of the corners in s_cells
#endif

#ifdef COARSE
    // Two cells at a time, while nothing in the 5 x 5 cells around is as high as the ray will be.
    float stride = 2.0 * min(per_cell.x, per_cell.y);
    for (int i = 0; i < u_most_turns && t + stride < t_end; ++i) {
        ivec2 cell = ivec2(floor(ray.start + t * ray.along)) & last;
        if (lowest_between(ray, t, t + stride) < texelFetch(s_around, cell, 0).r) break;
        t += stride;
    }
#endif
#ifdef MAX_MIPS
    int level = u_top_level;
#endif

    vec3 gap = vec3(0.0);
    float leaves = t;
    int turn = 0;
    for (; turn < u_most_turns && t < t_end; ++turn) {
        vec2 cell = floor(ray.start + t * ray.along + nudge);
#ifdef MAX_MIPS
        ivec2 node = ivec2(cell) >> level;
        vec2 out_of_node = leave_square(ray, inverse, vec2(node << level), float(1 << level));
        leaves = min(min(out_of_node.x, out_of_node.y), t_end);
        ivec2 corner = level == 0 ? ivec2(0) : ivec2(last.x + 1, last.y + 1 - ((last.y + 1) >> (level - 1)));
        float highest = texelFetch(s_bounds, corner + (node & (last >> level)), 0).g;
        if (lowest_between(ray, t, leaves) >= highest) {
            // Over it; and a level up where the ray also leaves the parent.
            t = leaves;
            ivec2 next = ivec2(floor(ray.start + t * ray.along + nudge)) >> level;
            if (level < u_top_level && (next >> 1) != (node >> 1)) ++level;
            continue;
        }
        if (level > 0) {
            --level;
            if (plain) t = max(t, 1.0 - highest);
            continue;
        }
#else
        vec2 out_of_cell = leave_square(ray, inverse, cell, 1.0);
        leaves = min(min(out_of_cell.x, out_of_cell.y), t_end);
#endif
#ifdef CELLS
        ivec4 known = texelFetch(s_cells, ivec3(ivec2(cell) & last, quadrant), 0);
        vec4 corners = vec4(known);
#else
        vec4 corners = textureGather(s_heights, (cell + 1.0) * texel);
#endif
        gap = gap_between(corners, scaled, t, leaves, cell);
        if (closes(gap)) break;
#if defined CELLS
        //(windows
        vec4 out_of_window = min(out_of_cell.x + u_grown * per_cell.x, out_of_cell.y + u_grown * per_cell.y);
        vec4 clear = vec4(known & 0xff) * (1.0 / 255.0);
        t = next_look(leaves, out_of_window, above_until(ray, plain, t, clear));
        //)
#elif defined WINDOWS
        ivec2 block = ivec2(cell) >> u_block_shift, last_block = last >> u_block_shift;
        vec2 out_of_block = leave_square(ray, inverse, vec2(block << u_block_shift), float(1 << u_block_shift));
        vec4 out_of_window = min(out_of_block.x + u_grown * per_cell.x, out_of_block.y + u_grown * per_cell.y);
        ivec2 place = (block & last_block) + ivec2(quadrant * (last_block.x + 1), 0);
        vec4 clear = texelFetch(s_windows, place, 0);
        t = next_look(leaves, out_of_window, above_until(ray, plain, t, clear));
#elif defined CONES
        // Along the way the cone's wall rises and the ray falls.
        float top = max(max(corners.x, corners.y), max(corners.z, corners.w));
        float wall = length(along) / texelFetch(s_cones, ivec2(cell) & last, 0).r;
        float falls = -(ray.height.y + 2.0 * t * ray.height.z);
        t = max(leaves, t + (height_of(ray, t) - top) / max(falls + wall, 1e-9));
#elif defined MAX_MIPS
        t = leaves;
        ivec2 next = ivec2(floor(ray.start + t * ray.along + nudge));
        if ((next >> 1) != (node >> 1)) level = min(1, u_top_level);
#else
        t = leaves;
#endif
    }
    bool missed = t >= t_end;
    bool stopped = turn >= u_most_turns;
    return ReliefHit(missed ? t_end : stopped ? t : t + (leaves - t) * first_closing(gap), missed, turn + 1);
}
