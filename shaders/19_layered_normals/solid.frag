#version 410 core
// A pixel of a solid whose relief is a map on three planes, perpendicular to x, y and z. Solids are surfaces of
// |p|^2 + sum amplitude sin(k p + phase) = 1, whose normals and their change are known. A cube has neither.

#include "common/unfinished.glsl"
#include "19_layered_normals/task.glsl"
#include "19_layered_normals/stone.glsl"
#include "common/heat.glsl"
#include "common/srgb.glsl"

in vec3 v_position;
in vec3 v_normal;

uniform vec3 u_eye;
uniform vec3 u_to_light;
uniform vec4 u_lumps[8];  // k, phase
uniform float u_lump;     // amplitude of each
uniform float u_tile;     // side of the map's tile, metres
uniform float u_strength;
uniform float u_sharpness;
uniform float u_error_scale;
uniform float u_split;  // x in pixels; to its right are errors

uniform sampler2D s_detail_normals;  // mean normal, height

layout(location = 0) out vec4 o_color;

// The smooth surface: its normal, and the gradients of the normal's x, y and z as columns.
struct Surface {
    vec3 normal;
    mat3 turns;
};

Surface surface_at(vec3 p) {
    Surface surface = Surface(normalize(v_normal), mat3(0.0));
#ifndef CUBE
    vec3 outward = 2.0 * p;
    mat3 bend = mat3(2.0);
#ifdef ROCK
    for (int i = 0; i < 8; ++i) {
        vec3 k = u_lumps[i].xyz;
        float angle = dot(k, p) + u_lumps[i].w;
        outward += u_lump * cos(angle) * k;
        bend -= u_lump * sin(angle) * outerProduct(k, k);
    }
#endif
    surface.normal = normalize(outward);
    surface.turns = bend * (mat3(1.0) - outerProduct(surface.normal, surface.normal)) / length(outward);
#endif
    return surface;
}

//(planes
// What the three planes have at a place; plane i is perpendicular to axis i.
struct Planes {
    vec3 weights, heights;
    mat3 weight_gradients;
    mat3 frames[3];
    vec2 slopes[3];
    int reads;
};

Planes planes_at(Surface surface) {
    Planes planes;
    planes.weights = plane_weights(surface.normal, u_sharpness);
    planes.heights = vec3(0.0);
    planes.reads = 0;
    vec3 across = dFdx(v_position), up = dFdy(v_position);  // before any branch
    mat3 changes = mat3(0.0);
    for (int i = 0; i < 3; ++i) {
        planes.slopes[i] = vec2(0.0);
        planes.frames[i] = plane_frame(i, surface.normal[i] < 0.0 ? -1.0 : 1.0);
#ifndef PROBE_planes
        if (planes.weights[i] == 0.0) continue;
#endif
        mat2x3 along = mat2x3(planes.frames[i][0], planes.frames[i][1]);
#if defined PROBE || defined MEASURE
        vec4 texel = textureLod(s_detail_normals, v_position * along / u_tile, 0.0);
#else
        vec4 texel = textureGrad(s_detail_normals, v_position * along / u_tile, across * along / u_tile, up * along / u_tile);
#endif
        ++planes.reads;
        planes.slopes[i] = -u_strength * texel.xy / texel.z;
        planes.heights[i] = u_strength * u_tile * texel.w;
        // The derivative of w = a / (a_x + a_y + a_z) with a = |n|^sharpness is w (log a)' - w sum_j w_j (log a_j)'.
        if (surface.normal[i] != 0.0)
            changes[i] = planes.weights[i] * u_sharpness / surface.normal[i] * surface.turns[i];
    }
    vec3 sum = changes[0] + changes[1] + changes[2];
    planes.weight_gradients = changes - outerProduct(sum, planes.weights);
    return planes;
}
//)

mat3 gradients_of(Planes planes) {
    mat3 gradients = mat3(0.0);
    for (int i = 0; i < 3; ++i) gradients[i] = gradient_in(planes.frames[i], planes.slopes[i]);
    return gradients;
}

vec3 by_gradient(Planes planes, mat3 weight_gradients) {
    return relief_gradient(planes.weights, planes.heights, gradients_of(planes), weight_gradients);
}

vec3 exact_normal(Surface surface, Planes planes) {
    return bumped(surface.normal, by_gradient(planes, planes.weight_gradients));
}

//(mappings
vec3 mapped(Surface surface, Planes planes) {
#if defined ONE_PLANE
    vec3 w = planes.weights;
    int largest = w.x >= max(w.y, w.z) ? 0 : w.y >= w.z ? 1 : 2;
    return bumped(surface.normal, gradient_in(planes.frames[largest], planes.slopes[largest]));
#elif defined GRADIENT
    return bumped(surface.normal, by_gradient(planes, mat3(0.0)));
#elif defined UDN || defined WHITEOUT || defined RNM
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 3; ++i) {
        vec2 slope = planes.slopes[i];
        vec3 normal = surface.normal, texel = vec3(-slope, 1.0) * inversesqrt(1.0 + dot(slope, slope));
#ifdef RNM
        vec3 inside = normal * planes.frames[i];  // in the plane's frame
        sum += planes.weights[i] * (planes.frames[i] * rotated_onto(inside, texel));
#else
#ifdef WHITEOUT
        normal[i] *= texel.z;
#endif
        sum += planes.weights[i] * (normal + gradient_in(planes.frames[i], texel.xy));
#endif
    }
    return normalize(sum);
#else
    return exact_normal(surface, planes);
#endif
}
//)

vec3 lit(Surface surface, Planes planes) {
    vec3 normal = mapped(surface, planes), to_eye = normalize(u_eye - v_position);
    float fine = dot(planes.weights, planes.heights) / u_tile * 30.0;
    vec3 light = stone_lit(0.65, fine, v_position.xy + v_position.yz, normal, surface.normal, u_to_light);
    float shine = pow(max(dot(normal, normalize(to_eye + u_to_light)), 0.0), 40.0);
    return light + vec3(1.0, 0.86, 0.66) * (0.08 * shine * step(0.0, dot(surface.normal, u_to_light)));
}

void main() {
    Surface surface = surface_at(v_position);
    Planes planes = planes_at(surface);
#if defined PROBE_normal
    o_color = probed(vec4(mapped(surface, planes), 0.0));
#elif defined PROBE_weights
    o_color = probed(vec4(planes.weights, 0.0));
#elif defined PROBE_gradient
    o_color = probed(vec4(by_gradient(planes, planes.weight_gradients), 0.0));
#elif defined PROBE_planes
    o_color = probed(vec4(gradients_of(planes) * vec3(1.0), 0.0));
#elif defined PROBE_reads
    o_color = probed(vec4(float(planes.reads), 0.0, 0.0, 0.0));
#elif defined PROBE
    discard;
#else
    vec3 normal = mapped(surface, planes), exact = exact_normal(surface, planes);
    float off = degrees(atan(length(cross(normal, exact)), dot(normal, exact)));
#ifdef MEASURE
    o_color = measured(vec4(off, float(planes.reads), 0.0, 0.0));
#else
    vec3 color = srgb_from_linear(lit(surface, planes));
#ifdef ERROR
    if (gl_FragCoord.x >= u_split) color = heat(off / u_error_scale);
#endif
    o_color = finished(vec4(color, 1.0), gl_FragCoord.xy);
#endif
#endif
}
