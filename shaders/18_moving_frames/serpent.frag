#version 410 core
// A pixel of a skin: its frame at rest, moved by the skin and by the instance, then its scales and its light.

#include "18_moving_frames/passed.glsl"
#include "18_moving_frames/skin.glsl"
#include "18_moving_frames/sky.glsl"
#include "common/unfinished.glsl"
#include "18_moving_frames/task.glsl"
#include "common/heat.glsl"
#include "common/light.glsl"
#include "common/srgb.glsl"

in vec2 v_uv;
in vec3 v_world;
flat in mat3 v_world_from_model;
flat in vec3 v_origin;
flat in mat3 v_texture;

uniform mat3 u_materials[8];    // texture transforms
uniform sampler2D s_scales;     // normals, and heights in the fourth channel
uniform float u_relief;         // strength of the normals
uniform vec3 u_eye;
uniform vec3 u_to_light;
uniform bool u_folds;           // paint the skin where it folds over itself

// The colours of the materials.
const vec3 backs[8] = vec3[](vec3(0.05, 0.26, 0.24), vec3(0.28, 0.10, 0.05), vec3(0.06, 0.13, 0.32),
                             vec3(0.30, 0.24, 0.05), vec3(0.17, 0.06, 0.20), vec3(0.10, 0.20, 0.07),
                             vec3(0.22, 0.22, 0.23), vec3(0.33, 0.05, 0.06));
const vec3 bellies[8] = vec3[](vec3(0.62, 0.55, 0.34), vec3(0.66, 0.48, 0.28), vec3(0.50, 0.55, 0.58),
                               vec3(0.60, 0.60, 0.42), vec3(0.58, 0.42, 0.45), vec3(0.58, 0.60, 0.36),
                               vec3(0.62, 0.60, 0.56), vec3(0.64, 0.40, 0.28));
const float fog = 0.028;         // share of light that is lost per metre
const float error_scale = 30.0;  // error of the brightest colour (pale yellow), degrees

layout(location = 0) out vec4 o_color;

vec3 unit_or(vec3 v, vec3 otherwise) {
    float squared = dot(v, v);
    return squared > 0.0 ? v * inversesqrt(squared) : otherwise;
}

// The motion of the skin at a place, by four bones, or by one motion that is blended from four.
struct Moves {
    vec3 place;
    mat3 jacobian;
    mat3 blend;  // the Jacobian without the derivatives of the weights
    Influence influence;
};

//(moves
Moves moves_at(vec3 rest) {
    Moves moves;
#ifdef RIGID
    moves.place = rest;
    moves.jacobian = moves.blend = mat3(1.0);
#else
    moves.influence = influence_at(rest.x);
    vec4 weights = moves.influence.weights, slopes = moves.influence.slopes;
    int first = moves.influence.first;
#ifdef DUAL
    mat2x4 bones[4], sum = mat2x4(0.0), change = mat2x4(0.0);
    for (int i = 0; i < 4; ++i) {
        bones[i] = motion_of(first + i);
        mat2x4 alike = mat2x4(u_rotations[first + i], u_duals[first + i]);
        sum += weights[i] * alike;
        change += slopes[i] * alike;
    }
    mat2x4 motion = blended_motion(weights, bones);
    moves.place = moved_by(motion, motion, rest);
    moves.blend = moves.jacobian = rotation_of(motion[0]);
    // The quotient rule. Numerator and denominator are quadratic forms of the blend.
    float square = dot(sum[0], sum[0]);
    vec3 place = moved_by(sum, sum, rest) / square;
    moves.jacobian[0] += 2.0 * (moved_by(sum, change, rest) - place * dot(sum[0], change[0])) / square;
#else
    mat4 bones[4];
    vec3 gradients[4];
    mat4 sum = mat4(0.0);
    for (int i = 0; i < 4; ++i) {
        bones[i] = u_bones[first + i];
        gradients[i] = vec3(slopes[i], 0.0, 0.0);
        sum += weights[i] * bones[i];
    }
    vec4 place = sum * vec4(rest, 1.0);
    moves.place = place.xyz / place.w;
    moves.blend = mat3(sum) / place.w;
#ifdef NEEDS_JACOBIAN
    moves.jacobian = skin_jacobian(rest, weights, gradients, bones);
#endif
#endif
#endif
    return moves;
}
//)

// Returns the normal moved by the inverse transpose of m, or by m itself if m is singular.
vec3 by_inverse(vec3 normal, mat3 m) {
    float size = determinant(m);
    return abs(size) > 1e-12 ? transpose(inverse(m)) * normal : m * normal;
}

// Returns the normal moved by the derivative of the motion, which is exact.
vec3 exact_normal(vec3 normal, Moves moves) { return moved_normal(normal, v_world_from_model * moves.jacobian); }

//(ways
// Returns the normal by the knob `normal_by`.
vec3 skin_normal(vec3 normal, Moves moves) {
#if defined GRADIENT
    return exact_normal(normal, moves);
#else
    vec3 posed = moves.blend * normal;
#if defined INVERSE_TRANSPOSE && !defined DUAL && !defined RIGID
    posed = by_inverse(normal, moves.blend);
#elif defined UNIT_COFACTORS && !defined DUAL && !defined RIGID
    posed = vec3(0.0);
    for (int i = 0; i < 4; ++i)
        posed += moves.influence.weights[i] * unit_or(u_bone_normals[moves.influence.first + i] * normal, vec3(0.0));
#endif
    return by_inverse(posed, v_world_from_model);
#endif
}
//)

#ifdef TEXTURED
mat3 material_texture() { return u_materials[passed_material()]; }
#endif

// texture_at() returns the coordinates at which the texture is read. directions_at() returns the unit directions of the
// skin at rest along which they grow.
vec2 texture_at(vec2 uv) {
#ifdef TEXTURED
    return texture_place(uv, v_texture, material_texture());
#else
    return uv;
#endif
}
mat2x3 directions_at(Rest rest) {
    mat2x3 along = rest.along;
#ifdef TEXTURED
    along = texture_directions(along, v_texture, material_texture());
#endif
    return mat2x3(unit_or(along[0], vec3(0.0, 0.0, 1.0)), unit_or(along[1], vec3(1.0, 0.0, 0.0)));
}

#ifdef ZEBRA
// Parallel lamps, whose mirror images show the smoothness of a surface, as in car design.
float lamps(vec3 mirrored) {
    float place = atan(mirrored.x, mirrored.y) * 1.9, width = fwidth(place) + 0.02;
    float off = abs(fract(place) - 0.5);
    return smoothstep(0.26 + width, 0.26 - width, off) * smoothstep(-0.95, -0.2, mirrored.y);
}
#endif

vec3 lit(Rest rest, Moves moves) {
    vec3 to_eye = normalize(u_eye - v_world);
    vec3 normal = rest.normal;
    float height = 0.7;
#ifdef BUMPS
    vec4 texel = texture(s_scales, texture_at(v_uv));
    mat2x3 along = directions_at(rest);
    mat3 frame = mat3(along[0], along[1], normal);
    vec3 scale = vec3(u_relief * (2.0 * texel.xy - 1.0), 2.0 * texel.z - 1.0);
    if (abs(determinant(frame)) > 1e-6) normal = normalize(transpose(inverse(frame)) * scale);
    height = texel.a;
#endif
    normal = unit_or(skin_normal(normal, moves), to_eye);
    vec3 smooth_normal = unit_or(skin_normal(rest.normal, moves), to_eye);
#ifdef ZEBRA
    vec3 clay = vec3(0.36, 0.25, 0.17);
    vec3 light = clay * mix(vec3(0.05, 0.055, 0.065), vec3(0.16, 0.18, 0.21), 0.5 + 0.5 * normal.y);
    light += vec3(1.15, 1.05, 0.9) * blinn_phong(clay, 0.02, 30.0, normal, u_to_light, to_eye);
    light += vec3(0.13, 0.145, 0.16) * lamps(reflect(-to_eye, normal));
    if (!gl_FrontFacing) light = vec3(0.02);
    return light;
#else
    int material = passed_material();
    float belly = 1.0 - smoothstep(-0.75, -0.05, -cos(turn_rad * v_uv.x));
    vec3 albedo = mix(backs[material], bellies[material], belly);
    // Saddles along the back, darker.
    float saddle = sin(turn_rad * 9.0 * v_uv.y + 1.3 * sin(turn_rad * v_uv.x * 2.0));
    albedo *= mix(1.0, 0.42, (1.0 - belly) * smoothstep(0.15, 0.55, saddle));
    albedo *= 0.35 + 0.75 * height;
    float facing = max(dot(normal, to_eye), 0.0), rim = pow(1.0 - max(dot(smooth_normal, to_eye), 0.0), 3.0);
    float gate = smoothstep(-0.15, 0.25, dot(smooth_normal, u_to_light));
    vec3 light = albedo * mix(vec3(0.05, 0.075, 0.09), vec3(0.24, 0.30, 0.36), 0.5 + 0.5 * normal.y) * (0.4 + 0.6 * height);
    light += vec3(3.0, 2.3, 1.6) * gate * blinn_phong(albedo, 0.10, 38.0, normal, u_to_light, to_eye);
    light += rim * (0.25 + 0.75 * facing) * mist(reflect(-to_eye, normal), u_to_light);
#ifdef SERPENT
    // An eye on each side of the head.
    vec2 off = (vec2(abs(v_uv.x - 0.5), v_uv.y) - vec2(0.155, 0.952)) * vec2(turn_rad * 0.21, 9.0);
    float away = length(off);
    vec3 iris = mix(vec3(0.95, 0.62, 0.10), vec3(0.25, 0.09, 0.02), smoothstep(0.03, 0.065, away));
    iris *= smoothstep(0.020, 0.030, length(off * vec2(1.0, 2.4)));
    vec3 wet = iris * (0.35 + max(dot(smooth_normal, u_to_light), 0.0)) +
               pow(max(dot(smooth_normal, normalize(u_to_light + to_eye)), 0.0), 220.0);
    light = mix(wet, light, smoothstep(0.062, 0.07, away));
#endif
    vec3 away_from_eye = v_world - u_eye;
    return mix(mist(normalize(away_from_eye), u_to_light), light, exp(-fog * max(length(away_from_eye) - 9.0, 0.0)));
#endif
}

vec3 with_folds(vec3 color, Moves moves) {
#if defined NEEDS_JACOBIAN || defined DUAL
    if (u_folds && determinant(moves.jacobian) <= 0.0) return vec3(0.10, 0.72, 0.95);
#endif
    return color;
}

float degrees_between(vec3 a, vec3 b) { return degrees(atan(length(cross(a, b)), dot(a, b))); }

void main() {
    Rest rest = rest_at(v_uv);
    Moves moves = moves_at(rest.position);
#if defined PROBE_normal
    o_color = probed(vec4(unit_or(skin_normal(rest.normal, moves), vec3(0.0, 0.0, 1.0)), 0.0));
#elif defined PROBE_tangent
    mat2x3 along = directions_at(rest);
    float handedness = dot(cross(along[0], along[1]), rest.normal) < 0.0 ? -1.0 : 1.0;
    vec4 tangent = moved_tangent(vec4(along[0], handedness), v_world_from_model * moves.jacobian);
    o_color = probed(vec4(unit_or(tangent.xyz, vec3(0.0, 0.0, 1.0)), tangent.w));
#elif defined PROBE_carried
    o_color = probed(vec4(v_world_from_model * moves.jacobian[0], 0.0));
#elif defined PROBE_fold
    o_color = probed(vec4(determinant(moves.jacobian), 0.0, 0.0, 0.0));
#elif defined PROBE_place
    o_color = probed(vec4(v_world_from_model * moves.place + v_origin, 0.0));
#elif defined PROBE_uv
    o_color = probed(vec4(texture_at(v_uv), 0.0, 0.0));
#elif defined PROBE_material
    o_color = probed(vec4(passed_material(), 0.0, 0.0, 0.0));
#elif defined MEASURE || defined ERROR
    vec3 wrong = skin_normal(rest.normal, moves), right = exact_normal(rest.normal, moves);
    float off = degrees_between(wrong, right);
#ifdef MEASURE
    o_color = measured(vec4(off, 0.0, 0.0, 0.0));
#else
    o_color = finished(vec4(with_folds(heat(off / error_scale), moves), 1.0), gl_FragCoord.xy);
#endif
#else
    o_color = finished(vec4(with_folds(srgb_from_linear(lit(rest, moves)), moves), 1.0), gl_FragCoord.xy);
#endif
}
