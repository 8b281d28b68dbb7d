#version 410 core
// The level of each edge of a patch, and whether the patch is culled.

#include "common/unfinished.glsl"
#include "14_adaptive_displacement/task.glsl"
#include "14_adaptive_displacement/patch_rows.glsl"
#include "14_adaptive_displacement/verdict.glsl"
#include "common/patch_corner.glsl"

layout(vertices = CORNERS) out;

in PatchCorner v_corner[];
in int v_vertex[];

out PatchCorner c_corner[];
patch out int c_patch;
patch out float c_level;  // the highest
patch out int c_verdict;
patch out float c_unfinished;

uniform vec3 u_eye;
uniform vec4 u_planes[6];
uniform float u_scale;              // of the relief, metres
uniform float u_most_level;         // maximum level, for the picture's limit of triangles
uniform float u_level;              // for the method `uniform`
uniform vec4 u_by_distance;         // nearest, farthest, exponents there
uniform float u_pixels_per_radian;
uniform float u_pixels_per_segment;
uniform float u_budget;             // pixels
uniform vec2 u_fade;                // its begin and end, metres from the eye
uniform bool u_culls_outside;       // culls patches outside of the picture
uniform bool u_culls_backs;         // and those that face away
uniform bool u_show_culled;
uniform sampler2D s_patches;        // see patch_rows.glsl

vec4 known(int row) {
    int number = v_vertex[0] / CORNERS;
    return texelFetch(s_patches, ivec2(number % patches_a_line * rows_a_patch + row, number / patches_a_line), 0);
}

// Returns the distance from the eye to a sphere, 0 in it. An edge lies in the sphere whose diameter it is.
float nearest(vec3 centre, float radius) {
    precise float away = max(distance(centre, u_eye) - radius, 0.0);
    return away;
}

// Whether the displacement has faded out in the whole sphere.
bool is_faded(vec3 centre, float radius) {
#ifdef FADE
    return remaining(nearest(centre, radius), u_fade.x, u_fade.y) == 0.0;
#else
    return false;
#endif
}

// Returns the level of an edge or of the inside by the errors of its levels, which `row` and the next one have.
// `middle` and `half_` are a sphere around it before displacement. `direction` (not unit) is that of the displacement.
float level_by_errors(vec3 middle, float half_, vec3 direction, int row) {
    vec4 coarse = known(row), fine = known(row + 1);
    precise vec3 pressed = middle + u_scale * (fine.w - 1.0) * normalize(direction);
    float tolerance = tolerated(nearest(pressed, half_), u_pixels_per_radian, u_budget, u_scale);
    return level_by_error(coarse, fine, tolerance);
}

// Returns the level of the edge from a to b.
float level_of(vec3 a, vec3 b, vec3 direction, int row) {
    precise vec3 middle = 0.5 * (a + b);
    precise float half_ = 0.5 * distance(a, b);
    if (is_faded(middle, half_)) return 1.0;
#if defined BY_DISTANCE
    return level_by_distance(a, b, u_eye, u_by_distance.x, u_by_distance.y, u_by_distance.z, u_by_distance.w);
#elif defined BY_SIZE
    return level_by_size(a, b, u_eye, u_pixels_per_radian, u_pixels_per_segment);
#elif defined BY_ERROR
    return level_by_errors(middle, half_, direction, row);
#else
    return u_level;
#endif
}

// Returns the level of the inside, before its edges are known. `flat_` is a sphere around the corners.
float level_of_inside(vec4 flat_) {
#ifdef BY_ERROR
    return is_faded(flat_.xyz, flat_.w) ? 1.0 : level_by_errors(flat_.xyz, flat_.w, known(row_axis).xyz, row_inside);
#else
    return 1.0;
#endif
}

// Returns the upper bound of the tangent of the angle between a triangle's normal and the patch's axis: see facing_of()
// in labs/14_adaptive_displacement/facing.h. A thin triangle is steeper than the relief. If all levels are equal, triangles have right angles in the
// domain of a quad, and nearly so in that of a triangle. Otherwise the corner opposite to an edge may be off by as much
// as the inside is finer than the edge.
float steepest(float flat_rise, vec4 facing, float inside, float least, bool is_flat) {
    float off = inside == least ? (CORNERS == 4 ? 0.0 : 0.5) : inside / least, lean = 1.0 + 2.0 * facing.w * off;
    float stretch = facing.z * sqrt(1.0 + lean * lean);
    if (is_flat) return flat_rise * stretch;
    float rest = 1.0 - facing.y * stretch;
    return rest > 0.0 ? facing.x * stretch / rest : 1e30;
}

// Returns the maximum and the minimum of the displacement that is left on a patch.
vec2 left_on(vec4 flat_) {
#ifdef FADE
    return vec2(remaining(nearest(flat_.xyz, flat_.w), u_fade.x, u_fade.y),
                remaining(distance(flat_.xyz, u_eye) + flat_.w, u_fade.x, u_fade.y));
#else
    return vec2(1.0);
#endif
}

// Returns a sphere around the displaced patch.
vec4 bounds_of(vec4 flat_, vec2 left) {
    vec4 heights = known(row_heights);
    float lowest = 1.0 + left.x * (heights.x - 1.0);
    float highest = 1.0 + (heights.y > 1.0 ? left.x : left.y) * (heights.y - 1.0);
    return relief_bounds(flat_, known(row_axis).xyz, heights.z, lowest, highest, u_scale);
}

bool shows_its_back(vec2 left, vec4 sphere, float inside, float least) {
    // A relief that is fading out is steeper than its map, so its slopes are not bounded.
    bool is_flat = left.x == 0.0, is_whole = left.y == 1.0;
    if (!u_culls_backs || !(is_flat || is_whole)) return false;
    vec4 axis = known(row_axis);
    return faces_away(axis.xyz, steepest(axis.w, known(row_steepness), inside, least, is_flat), sphere, u_eye);
}

void main() {
    // A patch outside of the picture needs no levels.
    vec4 flat_ = known(row_sphere);
    vec2 left = left_on(flat_);
    vec4 sphere = u_culls_outside || u_culls_backs ? bounds_of(flat_, left) : vec4(0.0);
    bool is_out = u_culls_outside && is_outside(u_planes, sphere);
    if (!is_out || u_show_culled) c_corner[gl_InvocationID] = v_corner[gl_InvocationID];
    if (gl_InvocationID != 0) return;
    vec4 edges = vec4(1.0);
    float inside = 1.0, least = 64.0;
    c_patch = v_vertex[0] / CORNERS;
    c_verdict = is_out ? verdict_outside : verdict_drawn;
    if (!is_out) {
        inside = level_of_inside(flat_);
#ifdef LEVELS_OF_PATCH
        // As in textbooks: one level from the patch's middle. Its neighbour has another level, so cracks open.
#ifdef BY_ERROR
        edges = vec4(inside);
#else
        vec3 half_ = 0.5 * (v_corner[1].position - v_corner[0].position);
        edges = vec4(level_of(flat_.xyz - half_, flat_.xyz + half_, known(row_axis).xyz, row_inside));
#endif
#else
        //(edges
        for (int i = 0; i < CORNERS; ++i) {
            int next = (i + 1) % CORNERS;
            edges[i] = level_of(v_corner[i].position, v_corner[next].position,
                                v_corner[i].direction + v_corner[next].direction, row_edges + 2 * i);
        }
        //)
#endif
        // Both neighbours of an edge clamp it to the same level.
        edges = min(edges, u_most_level);
        inside = min(inside, u_most_level);
        for (int i = 0; i < CORNERS; ++i) {
            // An inside that is coarser than its edges would be joined to them by slivers as steep as walls.
            inside = max(inside, edges[i]);
            least = min(least, edges[i]);
        }
        if (shows_its_back(left, sphere, inside, least)) c_verdict = verdict_away;
    }
    c_level = inside;
    //(outer
    if (c_verdict != verdict_drawn) edges = vec4(inside = u_show_culled ? 1.0 : 0.0);
#if CORNERS == 4
    vec4 outer = outer_levels_of_quad(edges);
#else
    vec4 outer = outer_levels_of_triangle(edges.xyz);
#endif
    for (int i = 0; i < 4; ++i) gl_TessLevelOuter[i] = outer[i];
    for (int i = 0; i < 2; ++i) gl_TessLevelInner[i] = inside;
    //)
    c_unfinished = float(is_unfinished);
}
