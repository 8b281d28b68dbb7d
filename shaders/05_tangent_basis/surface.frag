#version 410 core
// Bricks on a surface by its tangents: lit, or as the angle between the tangent and dP/du.

#include "common/unfinished.glsl"
#include "05_tangent_basis/task.glsl"
#include "common/heat.glsl"
#include "common/light.glsl"
#include "common/srgb.glsl"

in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
#ifndef DERIVATIVES
in vec4 v_tangent;
#endif
#if defined AVERAGED || defined ORTHOGONAL
in vec3 v_bitangent;
#endif

uniform vec3 u_eye;
uniform vec3 u_light;
uniform vec2 u_repeat;
uniform float u_split;  // x in pixels: lit to its left, the error to its right
uniform float u_shear;
uniform sampler2D s_albedo;
uniform sampler2D s_normals;

layout(location = 0) out vec4 o_color;

// A probe shows the task's result, so the exact solution must not be available to it.
#if !defined PROBE_tangent && !defined PROBE_bitangent && !defined PROBE_dp_dv && !defined PROBE_frame
// Returns the unit dP/du of the exact surface.
vec3 exact_tangent() {
#if defined QUAD
    return normalize(vec3(1.0, -u_shear, 0.0));
#elif defined BOX
    return abs(v_normal.y) > 0.5 ? vec3(1.0, 0.0, 0.0) : normalize(cross(vec3(0.0, 1.0, 0.0), v_normal));
#elif defined MIRRORED
    // v_uv.x is |2 u - 1| with the u of the sphere. It grows to the right on the right half only.
    float turn = 3.14159265 * (1.0 + v_uv.x), side = v_position.x < 0.0 ? 1.0 : -1.0;
    return side * vec3(cos(side * turn), 0.0, -sin(side * turn));
#else
    float turn = 6.28318531 * v_uv.x;
    return vec3(cos(turn), 0.0, -sin(turn));
#endif
}

// Returns the unit dP/dv of the exact surface.
vec3 exact_bitangent() {
#ifdef BOX
    return cross(v_normal, exact_tangent());
#elif defined ROUND || defined TORUS
    vec3 out_ = cross(exact_tangent(), vec3(0.0, 1.0, 0.0));  // away from the axis
#ifdef TORUS
    float turn = 6.28318531 * v_uv.y;
    return sin(turn) * out_ - vec3(0.0, cos(turn), 0.0);
#else
    float latitude = 3.14159265 * (v_uv.y - 0.5);
#ifdef MIRRORED
    if (v_position.x > 0.0) out_ = -out_;  // its tangent points backwards
#endif
    return vec3(0.0, cos(latitude), 0.0) - sin(latitude) * out_;
#endif
#else
    return vec3(0.0, 1.0, 0.0);
#endif
}
#endif

//(tangent-here
vec4 tangent_here(vec3 normal) {
#ifdef DERIVATIVES
    return tangent_of_derivatives(normal, dFdx(v_position), dFdy(v_position), dFdx(v_uv), dFdy(v_uv));
#else
    return v_tangent;
#endif
}
//)

float degrees_between(vec3 a, vec3 b) { return degrees(atan(length(cross(a, b)), dot(a, b))); }

void main() {
    vec3 normal = normalize(v_normal);
    vec4 tangent = tangent_here(normal);
#if defined NORMAL_ALONE
    //(normal-alone
    vec3 across_z = cross(normal, vec3(0.0, 0.0, 1.0)), across_y = cross(normal, vec3(0.0, 1.0, 0.0));
    bool is_z_longer = dot(across_z, across_z) > dot(across_y, across_y);
    tangent = vec4(normalize(is_z_longer ? across_z : across_y), 1.0);
    //)
#elif defined ORTHOGONAL
    tangent.xyz = normalize(cross(cross(normal, tangent.xyz), normal));  // without its part along N
#endif
#if defined ORTHOGONAL
    vec3 rest = v_bitangent - dot(v_bitangent, normal) * normal - dot(v_bitangent, tangent.xyz) * tangent.xyz;
    // Nothing is left where T and B are parallel, as on a mesh whose uv are collapsed.
    vec3 bitangent = dot(rest, rest) > 1e-12 ? normalize(rest) : cross(normal, tangent.xyz);
#elif defined AVERAGED
    vec3 bitangent = v_bitangent;
#else
    vec3 bitangent = tangent.w * cross(normal, tangent.xyz);
#endif
#if defined MEASURE
    float between = abs(90.0 - degrees_between(tangent.xyz, bitangent));
    o_color = measured(vec4(degrees_between(tangent.xyz, exact_tangent()),
                            degrees_between(bitangent, exact_bitangent()), between, 1.0));
#elif defined PROBE_tangent
    o_color = probed(vec4(tangent.xyz, 0.0));
#elif defined SOLVED_BITANGENT
    o_color = probed(vec4(tangent.xyz, 0.0));  // B of the triangle stands there
#elif defined PROBE_bitangent || defined PROBE_dp_dv
    o_color = probed(vec4(bitangent, 0.0));
#elif defined PROBE_frame
    o_color = probed(vec4(length(tangent.xyz), dot(normalize(tangent.xyz), normal), tangent.w, 0.0));
#else
    vec3 color;
    if (gl_FragCoord.x > u_split) {
#ifdef FRAMES
        float error = degrees_between(bitangent, exact_bitangent());
#else
        float error = degrees_between(tangent.xyz, exact_tangent());
#endif
        color = log_heat(error, -2.0, 2.0);
    } else {
        vec2 uv = v_uv * u_repeat;
        //(bumped
        vec3 stored = texture(s_normals, uv).xyz * 2.0 - 1.0, albedo = texture(s_albedo, uv).rgb;
        vec3 bumped = normalize(stored.x * tangent.xyz + stored.y * bitangent + stored.z * normal);
        //)
        vec3 to_eye = normalize(u_eye - v_position), to_light = normalize(u_light - v_position);
        vec3 light = albedo * mix(vec3(0.10, 0.09, 0.08), vec3(0.24, 0.27, 0.32), 0.5 + 0.5 * bumped.y);
        light += vec3(1.5, 1.35, 1.2) * blinn_phong(albedo, 0.10, 40.0, bumped, to_light, to_eye);
        color = srgb_from_linear(light);
    }
    o_color = finished(vec4(color, 1.0), gl_FragCoord.xy);
#endif
}
