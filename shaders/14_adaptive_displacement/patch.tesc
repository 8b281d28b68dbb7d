#version 410 core
// How finely each edge of a patch is cut, and whether the patch is drawn at all.

#include "14_adaptive_displacement/task.glsl"
#include "common/patch_corner.glsl"

// The order of `methods` in lab.cpp.
#define UNIFORM 0
#define DISTANCE 1
#define SIZE 2
#define ERROR 3

layout(vertices = CORNERS) out;

in PatchCorner v_corner[];
in int v_vertex[];

out PatchCorner c_corner[];
patch out int c_patch;
patch out float c_level;  // the highest
patch out int c_verdict;  // 0 drawn, 1 outside of the picture, 2 seen from its back
patch out float c_unfinished;

uniform vec3 u_eye;
uniform vec4 u_planes[6];
uniform float u_scale;              // of the relief, metres
uniform float u_level;              // for UNIFORM
uniform vec4 u_by_distance;         // nearest, farthest, exponents there
uniform float u_pixels_per_radian;
uniform float u_pixels_per_segment;
uniform float u_budget;             // pixels
uniform vec2 u_fade;                // where it begins and ends, metres from the eye
uniform int u_cull;                 // 1 what is outside, 2 what faces away, too
uniform bool u_show_culled;
uniform sampler2D s_patches;        // see PatchTexture in scene.h

const int rows = 14, patches_a_line = 64;

vec4 known(int row) {
    int number = v_vertex[0] / CORNERS;
    return texelFetch(s_patches, ivec2(number % patches_a_line * rows + row, number / patches_a_line), 0);
}

// The nearest that an edge, or a sphere, with all that is pressed into it can be.
float nearest(vec3 centre, float radius) {
    precise float away = max(distance(centre, u_eye) - radius, 0.0);
    return away;
}

// Whether the displacement has faded away in all of a sphere.
bool is_faded(vec3 centre, float radius) {
#ifdef FADE
    return remaining(nearest(centre, radius), u_fade.x, u_fade.y) == 0.0;
#else
    return false;
#endif
}

float level_of(vec3 a, vec3 b, vec4 coarse, vec4 fine) {
    precise vec3 middle = 0.5 * (a + b);
    precise float half_ = 0.5 * distance(a, b);
    if (is_faded(middle, half_)) return 1.0;
#if METHOD == DISTANCE
    return level_by_distance(a, b, u_eye, u_by_distance.x, u_by_distance.y, u_by_distance.z, u_by_distance.w);
#elif METHOD == SIZE
    return level_by_size(a, b, u_eye, u_pixels_per_radian, u_pixels_per_segment);
#elif METHOD == ERROR
    float away = nearest(middle, half_ + u_scale);
    return level_by_error(coarse, fine, tolerated(away, u_pixels_per_radian, u_budget, u_scale));
#else
    return u_level;
#endif
}

// Of the inside, by itself. `flat_` is a sphere around the corners.
float level_of_inside(vec4 flat_) {
#if METHOD == ERROR
    if (is_faded(flat_.xyz, flat_.w)) return 1.0;
    float away = nearest(flat_.xyz, flat_.w + u_scale);
    return level_by_error(known(4), known(5), tolerated(away, u_pixels_per_radian, u_budget, u_scale));
#else
    return 1.0;
#endif
}

// The relief's steepest triangle leans no further than this from the patch's axis, as a tangent: see facing_of() in scene.h.
// A triangle may be thin, and is then steeper than the relief. With one level all have right angles in the domain of a quad, and
// nearly so in that of a triangle; else the corner beside an edge may lie off by as much as the inside is finer than the edge.
float steepest(vec4 flat_, float flat_rise, vec4 facing, float inside, float least, bool is_flat) {
    float off = inside == least ? (CORNERS == 4 ? 0.0 : 0.5) : inside / least, lean = 1.0 + 2.0 * facing.w * off;
    float stretch = facing.z * sqrt(1.0 + lean * lean);
    if (is_flat) return flat_rise * stretch;
    float rest = 1.0 - facing.y * stretch;
    return rest > 0.0 ? facing.x * stretch / rest : 1e30;
}

int verdict(vec4 flat_, float inside, float least) {
    if (u_cull == 0) return 0;
    vec4 heights = known(0), axis = known(2), facing = known(3);
    float most_left = 1.0, least_left = 1.0;
#ifdef FADE
    most_left = remaining(nearest(flat_.xyz, flat_.w), u_fade.x, u_fade.y);
    least_left = remaining(distance(flat_.xyz, u_eye) + flat_.w, u_fade.x, u_fade.y);
#endif
    float lowest = 1.0 + most_left * (heights.x - 1.0);
    float highest = 1.0 + (heights.y > 1.0 ? most_left : least_left) * (heights.y - 1.0);
    vec4 sphere = relief_bounds(flat_, axis.xyz, heights.z, lowest, highest, u_scale);
    if (is_outside(u_planes, sphere)) return 1;
    // Where the relief is fading it is steeper than the map says.
    bool is_flat = most_left == 0.0, is_whole = least_left == 1.0;
    if (u_cull == 1 || !(is_flat || is_whole)) return 0;
    return faces_away(axis.xyz, steepest(flat_, axis.w, facing, inside, least, is_flat), sphere, u_eye) ? 2 : 0;
}

void main() {
    c_corner[gl_InvocationID] = v_corner[gl_InvocationID];
    if (gl_InvocationID != 0) return;
    vec4 flat_ = known(1), edges = vec4(1.0);
    float inside = level_of_inside(flat_);
#ifdef LEVELS_OF_PATCH
    // The textbook's: one level, from the patch's middle. Its neighbour has another.
    vec3 half_ = 0.5 * (v_corner[1].position - v_corner[0].position);
    edges = vec4(METHOD == ERROR ? inside : level_of(flat_.xyz - half_, flat_.xyz + half_, vec4(0.0), vec4(0.0)));
#else
    for (int i = 0; i < CORNERS; ++i)
        edges[i] = level_of(v_corner[i].position, v_corner[(i + 1) % CORNERS].position, known(6 + 2 * i), known(7 + 2 * i));
#endif
    float least = 64.0;
    for (int i = 0; i < CORNERS; ++i) {
        // An inside that is coarser than its edges is joined to them by slivers as steep as walls.
        inside = max(inside, edges[i]);
        least = min(least, edges[i]);
    }
    c_patch = v_vertex[0] / CORNERS;
    c_level = inside;
    c_verdict = verdict(flat_, inside, least);
    if (c_verdict != 0) edges = vec4(inside = u_show_culled ? 1.0 : 0.0);
#if CORNERS == 4
    vec4 outer = outer_levels_of_quad(edges);
#else
    vec4 outer = outer_levels_of_triangle(edges.xyz);
#endif
    c_unfinished = float(is_unfinished);
    for (int i = 0; i < 4; ++i) gl_TessLevelOuter[i] = outer[i];
    for (int i = 0; i < 2; ++i) gl_TessLevelInner[i] = inside;
}
