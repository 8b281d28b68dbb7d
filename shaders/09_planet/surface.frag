#version 410 core
// The planet, lit by the sun by the normals of its map. Colours depend on height, slope and latitude. Air is in front.

#include "09_planet/air.glsl"
#include "09_planet/depth.glsl"
#include "09_planet/ground.glsl"
#include "09_planet/map.glsl"
#include "common/heat.glsl"
#include "common/srgb.glsl"
#include "common/unfinished.glsl"
#ifdef BUMPS
#include "09_planet/grid.glsl"
#include "09_planet/bumps.glsl"
uniform mat3 u_face;
uniform vec4 u_patch_on_face;  // s and t of its lower left corner, then of its upper right one
#endif

in vec3 v_from_eye;
in vec2 v_local;
in vec4 v_air;  // between here and the eye: light, opacity
#ifdef VERTEX_NORMALS
in vec3 v_normal;
#endif

uniform float u_radius;
uniform vec3 u_eye;        // radii
uniform float u_level;     // of the patch; -1 hidden, -2 outside of the picture
uniform float u_skirt;
uniform float u_quads;

layout(location = 0) out vec4 o_color;

void main() {
    write_depth();
    vec3 from_eye = v_from_eye / u_radius, place = u_eye + from_eye;
#if defined PROBE_seen
    o_color = vec4(1.0, 0.0, 0.0, 0.0);
#elif defined PROBE_level
    o_color = vec4(u_level, 0.0, 0.0, 0.0);
#elif defined PROBE_skirt
    o_color = vec4(u_skirt, 0.0, 0.0, 0.0);
#elif defined PROBE_place
    o_color = vec4(v_from_eye, 0.0);
#else
    vec4 texel = map_at(v_local);
#ifdef VERTEX_NORMALS
    vec3 normal = normalize(v_normal);
#else
    vec3 normal = texel.xyz;
#endif
    if (texel.w < -8.0) is_unfinished = true;
#ifdef PROBE_normal
    o_color = probed(vec4(normal, 0.0));
#else
    float distance_ = length(from_eye);
    vec3 to_eye = -from_eye / distance_, up = normalize(place);
#ifdef PATCHES
    vec3 albedo = u_level < -1.5   ? vec3(0.045, 0.055, 0.085)
                  : u_level < -0.5 ? vec3(0.10, 0.06, 0.05)
                                   : 0.8 * heat(0.25 + 0.09 * u_level);
    vec2 edge = min(v_local, 1.0 - v_local), line = fwidth(v_local);
    float border = min(smoothstep(0.5, 1.7, edge.x / line.x), smoothstep(0.5, 1.7, edge.y / line.y));
    vec2 cell = abs(fract(v_local * u_quads - 0.5) - 0.5) / (line * u_quads);
    if (u_level > -0.5) albedo *= mix(0.72, 1.0, smoothstep(0.2, 1.2, min(cell.x, cell.y)));
    albedo *= mix(0.25, 1.0, border);
    float facing = max(dot(normal, u_to_sun), 0.0), gloss = 0.0;
    vec3 light = albedo * (0.30 + 0.9 * facing);
#else
    vec3 albedo;
    float gloss;
    ground(texel.w, up, normal, place, albedo, gloss);
#ifdef BUMPS
    normal = bumped(normal, u_face, mix(u_patch_on_face.xy, u_patch_on_face.zw, v_local));
    gloss = 0.0;  // highlights on the sea's bricks would sparkle
#endif
    vec3 sun = sunlight(length(place) - 1.0, dot(up, u_to_sun));
    float facing = max(dot(normal, u_to_sun), 0.0);
    vec3 half_ = normalize(u_to_sun + to_eye);
    float wide = pow(max(dot(normal, half_), 0.0), 64.0), narrow = wide * wide;
    narrow *= narrow * narrow;
    float glint = gloss * (0.6 * wide + 4.0 * narrow);
    vec3 sky = vec3(0.05, 0.09, 0.17) * smoothstep(-0.25, 0.5, dot(up, u_to_sun)) * (0.6 + 0.4 * dot(normal, up));
    vec3 light = albedo * (2.4 * sun * facing + sky + vec3(0.0020, 0.0026, 0.0045));
    light += sun * glint * step(-0.1, dot(up, u_to_sun));
    // The sea mirrors the sky at grazing angles.
    float graze = 1.0 - max(dot(normal, to_eye), 0.0);
    light += gloss * graze * graze * graze * sky * 3.0;
    light = light * (1.0 - 0.75 * v_air.w) + v_air.xyz;
#endif
    o_color = finished(vec4(srgb_from_linear(exposed(light)), 1.0), gl_FragCoord.xy);
#endif
#endif
}
