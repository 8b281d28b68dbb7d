// The exact first hit of a ray and a height map: one test of a cell, and five methods to skip cells without a hit.
//
// RELAXED is another search, for comparison: see relaxed.glsl.
//
// Each iteration tests one cell, the bilinear surface between four texel centres. Then it advances to a place that the
// ray reaches without a hit, at least to the next cell. So the methods have the same result. They differ in the number
// and the cost of their iterations. Each is a file with one function, next_t().

#include "common/cell_walk.glsl"
#include "common/height_cell.glsl"
#include "common/unfinished.glsl"
#include "12_relief_exact/task.glsl"

uniform sampler2D s_heights;
uniform float u_highest;  // maximum of all heights

struct ReliefHit {
    float t;
    bool missed;   // reached the end of the ray
    bool stopped;  // ran out of iterations above the surface
    int iterations;
};

// The input of next_t(): a ray that did not hit its cell. Places and `cell` are in texels from the cell in which the
// ray starts. That one is cell `first` of the map.
struct Look {
    ReliefRay ray;
    vec2 inverse, per_cell;  // 1 / ray.along, finite, and its absolute value
    float octant;    // of the ray's direction: see height_windows()
    bool plain;      // a view ray on a flat base: its height is 1 - t
    vec2 texel;      // size of a texel, in uv
    vec2 first, cell;
    float t, leaves;   // t at which the ray enters the cell, and leaves it
    vec2 out_of_cell;  // t at which it is at the wall ahead, along u and along v
    vec4 corners;      // see cell_corners()
};

float height_of(ReliefRay ray, float t) {
    return ray.height.x + t * (ray.height.y + t * ray.height.z);
}

// Returns the t until which the ray is above 1 - clearance. Conservative for a ray that bends: it is above its tangent.
vec4 above_until(Look at, vec4 clearance) {
    if (at.plain) return clearance;
    float falls = -(at.ray.height.y + 2.0 * at.t * at.ray.height.z);
    return at.t + (height_of(at.ray, at.t) - 1.0 + clearance) / max(falls, 1e-9);
}

#ifdef RELAXED
#include "12_relief_exact/relaxed.glsl"
#else
#if defined COARSE
#include "12_relief_exact/coarse.glsl"
#elif defined WINDOWS
#include "12_relief_exact/windows.glsl"
#elif defined MAX_MIPS
#include "12_relief_exact/max_mips.glsl"
#elif defined CONES
#include "12_relief_exact/cones.glsl"
#else
float next_t(Look at) { return at.leaves; }  // cell by cell
#endif

#ifndef WINDOWS
void prepare(vec2 per_cell, float octant) {}  // computes constants of a method, once per ray
#endif

// As gap_above_cell(), for a ray that may bend. The middle Bernstein coefficient is the difference of their blossoms.
vec3 gap_between(vec4 corners, ReliefRay ray, float t0, float t1, vec2 cell) {
    vec2 a = ray.start + t0 * ray.along - cell, b = ray.start + t1 * ray.along - cell;
    float along_u = corners.z - corners.w, along_v = corners.x - corners.w;
    float twist = corners.y - corners.x - along_u;
    vec4 u = vec4(a.x, b.x, a.x, b.x), v = vec4(a.y, a.y, b.y, b.y);  // corners of the square between the two ends
    vec4 heights = corners.w + along_u * u + v * (along_v + twist * u);
    float middle = ray.height.x + 0.5 * (ray.height.y * (t0 + t1) - heights.y - heights.z) + ray.height.z * t0 * t1;
    return vec3(height_of(ray, t0) - heights.x, middle, height_of(ray, t1) - heights.w);
}

//(search
// Searches from t, where the ray is not below the surface, to t_end. `before`: iterations used by the pixel.
ReliefHit first_hit(ReliefRay ray, bool plain, float t, float t_end, int before) {
    vec2 size = vec2(textureSize(s_heights, 0)), texel = 1.0 / size, first = floor(mod(ray.start, size));
    ray.start = fract(ray.start);
    vec2 way = way_of(ray.along), per_cell = 1.0 / max(abs(ray.along), vec2(1e-9)), inverse = way * per_cell;
    float octant = octant_of(ray.along, way);
    vec2 ahead = start_along(ray.start, way), by = abs(ray.along), passed = floor(ahead + t * by);
    // Computed before the loop: a software renderer would compute it in each iteration.
    vec2 out_of_first = leave_square(ray, inverse, vec2(0.0), 1.0);
    prepare(per_cell, octant);
    vec3 gap = vec3(0.0);
    float leaves = t;
    int iteration = 0, last = min(iterations_between(ray.along, t, t_end), max_iterations - before);
    for (; iteration < last && t < t_end; ++iteration) {
        vec2 cell = way * passed, out_of_cell = out_of_first + passed * per_cell;
        leaves = clamp(min(out_of_cell.x, out_of_cell.y), t, t_end);
        vec4 corners = textureGather(s_heights, (first + cell + 1.0) * texel);
        gap = gap_between(corners, ray, t, leaves, cell);
        if (closes(gap)) break;
        t = next_t(Look(ray, inverse, per_cell, octant, plain, texel, first, cell, t, leaves, out_of_cell, corners));
        passed = next_cell(passed, out_of_cell, ahead + t * by);
    }
    bool missed = t >= t_end, stopped = !missed && iteration >= last;
    if (!missed && !stopped) t += (leaves - t) * first_closing(gap);
    return ReliefHit(missed ? t_end : t, missed, stopped, iteration + 1);
}
//)
#endif
