#version 410 core
// A texel of the map: the ray from its place, its hit, and the normal there in the coarse model's frame.

#include "07_baking/frames.glsl"
#include "07_baking/walk.glsl"

in vec3 v_position;
in vec3 v_normal;
in vec4 v_tangent;
in vec2 v_uv;

uniform vec4 u_layout;  // of the map: lowest v of a strip, distance of strips, lowest u, extent of u
uniform float u_reach;  // metres at turn 3
uniform float u_growth;

// xyz: the normal, from -1 to 1; w: 1 covered, 2 a task is unfinished
layout(location = 0) out vec4 o_texel;
// x: height, metres; y: 0 miss, 1 hit, 2 another part of the model; z: 1 or 2 if task 7.1 or 7.2 is unfinished
layout(location = 1) out vec4 o_hit;

float turn_here() {
    float whorl = clamp(floor((v_uv.y - 0.5 * u_layout.x) / u_layout.y), 0.0, 2.0);
    return whorl + (v_uv.x - u_layout.z) / u_layout.w;
}

void main() {
    vec3 outwards = finite_or(normalize(v_normal), vec3(0.0, 0.0, 1.0));
#ifdef RAYS_OF_FACE
    vec3 ray_normal = v_tangent.w * normalize(cross(dFdx(v_position), dFdy(v_position)));
#else
    vec3 ray_normal = v_normal;
#endif
    float reach = u_reach * pow(u_growth, turn_here() - 3.0);
    BakeRay ray = bake_ray(v_position, ray_normal, reach);
    float unwritten = is_unfinished ? 1.0 : 0.0;
    Found found = walk(ray, reach);
    if (is_unfinished && unwritten == 0.0) unwritten = 2.0;
    vec3 normal = outwards;  // the coarse model's own, unless the ray hits
    o_hit = vec4(0.0, 0.0, unwritten, 1.0);
    if (found.height < 1e29) {
        vec4 a = vertex_of(found.triangle, 0), b = vertex_of(found.triangle, 1), c = vertex_of(found.triangle, 2);
        normal = object_texel(a.xyz, b.xyz, c.xyz, found.weights);
        bool is_other = abs(a.w - turn_here()) > 0.5;
        o_hit = vec4(found.height, is_other ? 2.0 : 1.0, unwritten, 1.0);
    }
#ifndef OBJECT_SPACE
    normal = stored_normal(normal, frame_tangent(v_normal, v_tangent), frame_normal(v_normal));
#endif
    normal = finite_or(normal, vec3(0.0, 0.0, 1.0));
    o_texel = vec4(normal, is_unfinished ? 2.0 : 1.0);
}
