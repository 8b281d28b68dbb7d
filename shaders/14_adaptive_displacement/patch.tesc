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
patch out float c_level;   // the highest
patch out int c_verdict;   // 0 drawn, 1 outside of the picture, 2 seen from its back
patch out float c_unfinished;

uniform vec3 u_eye;
uniform vec4 u_planes[6];
uniform float u_scale;              // of the relief, metres
uniform float u_level;              // for UNIFORM
uniform vec4 u_by_distance;         // nearest, farthest, exponents there
uniform float u_pixels_per_radian;
uniform float u_pixels_per_segment;
uniform float u_budget;             // pixels
uniform int u_cull;                 // 1 what is outside, 2 what faces away, too
uniform bool u_show_culled;
uniform sampler2D s_patches;        // see PatchTexture in scene.h

const int rows = 12, patches_a_line = 64;

vec4 known(int row) {
    int number = v_vertex[0] / CORNERS;
    return texelFetch(s_patches, ivec2(number % patches_a_line * rows + row, number / patches_a_line), 0);
}

// The nearest that an edge, or a sphere, with all that is pressed into it can be.
float nearest(vec3 centre, float radius) { return max(distance(centre, u_eye) - radius, 0.0); }

float level_of(vec3 a, vec3 b, vec3 dir, vec4 coarse, vec4 fine) {
#if METHOD == DISTANCE
    return level_by_distance(a, b, u_eye, u_by_distance.x, u_by_distance.y, u_by_distance.z, u_by_distance.w);
#elif METHOD == SIZE
    return level_by_size(a, b, u_eye, u_pixels_per_radian, u_pixels_per_segment);
#elif METHOD == ERROR
    float away = nearest(0.5 * (a + b) + u_scale * (fine.w - 1.0) * normalize(dir), 0.5 * length(a - b));
    return possible_level(level_by_error(coarse, fine, tolerated(away, u_pixels_per_radian, u_budget, u_scale)));
#else
    return u_level;
#endif
}

// Of the flat patch: the sphere around its corners, its axis, and how far the relief's directions stray from that.
void measure(out vec4 sphere, out vec3 axis, out float spread, out float tilt) {
    vec3 centre = vec3(0.0);
    for (int i = 0; i < CORNERS; ++i) centre += v_corner[i].position / float(CORNERS);
#if CORNERS == 4
    vec3 across = cross(v_corner[2].position - v_corner[0].position, v_corner[3].position - v_corner[1].position);
#else
    vec3 across = cross(v_corner[1].position - v_corner[0].position, v_corner[2].position - v_corner[0].position);
#endif
    float area = length(across);
    axis = area > 0.0 ? across / area : v_corner[0].direction;
    sphere = vec4(centre, 0.0);
    spread = tilt = 0.0;
    float turn = 0.0, shortest = 1e30;
    for (int i = 0; i < CORNERS; ++i) {
        int next = (i + 1) % CORNERS;
        vec3 edge = v_corner[next].position - v_corner[i].position;
        sphere.w = max(sphere.w, distance(centre, v_corner[i].position));
        spread = max(spread, distance(axis, v_corner[i].direction));
        turn = max(turn, distance(v_corner[i].direction, v_corner[next].direction));
        shortest = min(shortest, length(edge));
        tilt = max(tilt, abs(dot(axis, edge)) / max(length(edge), 1e-30));
    }
    // A flat patch is steeper by how its corners leave their plane, and by how its directions turn over its width.
    tilt += u_scale * turn / max(0.5 * shortest, 1e-30);
}

int verdict(float most, float least) {
    if (u_cull == 0) return 0;
    vec4 heights = known(0), flat_;
    vec3 axis;
    float spread, tilt;
    measure(flat_, axis, spread, tilt);
    vec4 sphere = relief_bounds(flat_, axis, spread, heights.x, heights.y, u_scale);
    if (is_outside(u_planes, sphere)) return 1;
    if (u_cull == 1) return 0;
    // A chord is no steeper than the relief; a triangle can be, where its corners lie almost in a line: a segment of the
    // inside beside one of an edge.
    float chord = tilt + u_scale * heights.z, rest = 1.0 - tilt - u_scale * heights.z * spread;
    if (rest <= 0.1) return 0;
    float lean = 1.0 + 2.0 * most / least;
    return faces_away(axis, chord / rest * sqrt(1.0 + lean * lean), sphere, u_eye) ? 2 : 0;
}

void main() {
    c_corner[gl_InvocationID] = v_corner[gl_InvocationID];
    if (gl_InvocationID != 0) return;
    vec4 edges = vec4(1.0);
    float inside = 1.0;
#if METHOD == ERROR
    vec4 heights = known(0), flat_;
    vec3 axis;
    float spread, tilt;
    measure(flat_, axis, spread, tilt);
    vec4 sphere = relief_bounds(flat_, axis, spread, heights.x, heights.y, u_scale);
    float tolerance = tolerated(nearest(sphere.xyz, flat_.w), u_pixels_per_radian, u_budget, u_scale);
    inside = possible_level(level_by_error(known(1), known(2), tolerance));
#endif
#ifdef LEVELS_OF_PATCH
    // The textbook's: one level, from the patch's middle. Its neighbour has another.
    vec3 half_ = 0.5 * (v_corner[1].position - v_corner[0].position), middle = vec3(0.0);
    for (int i = 0; i < CORNERS; ++i) middle += v_corner[i].position / float(CORNERS);
    edges = vec4(METHOD == ERROR ? inside : level_of(middle - half_, middle + half_, v_corner[0].direction, vec4(0.0), vec4(0.0)));
#else
    for (int i = 0; i < CORNERS; ++i)
        edges[i] = level_of(v_corner[i].position, v_corner[(i + 1) % CORNERS].position, v_corner[i].direction + v_corner[(i + 1) % CORNERS].direction, known(3 + 2 * i), known(4 + 2 * i));
#endif
    float most = edges.x, least = edges.x;
    for (int i = 1; i < CORNERS; ++i) {
        most = max(most, edges[i]);
        least = min(least, edges[i]);
    }
#if METHOD != ERROR
    inside = most;
#endif
    c_patch = v_vertex[0] / CORNERS;
    c_level = max(most, inside);
    c_verdict = verdict(c_level, min(least, inside));
    c_unfinished = float(is_unfinished);
    if (c_verdict != 0) edges = vec4(inside = u_show_culled ? 1.0 : 0.0);
#if CORNERS == 4
    vec4 outer = outer_levels_of_quad(edges);
#else
    vec4 outer = outer_levels_of_triangle(edges.xyz);
#endif
    for (int i = 0; i < 4; ++i) gl_TessLevelOuter[i] = outer[i];
    for (int i = 0; i < 2; ++i) gl_TessLevelInner[i] = inside;
}
