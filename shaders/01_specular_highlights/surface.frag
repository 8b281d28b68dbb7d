#version 410 core
// One light and a highlight, by the vertex normal or by the normal map; or the lamp itself.

#include "common/unfinished.glsl"
#include "01_specular_highlights/task.glsl"
#include "01_specular_highlights/ggx.glsl"
#include "common/light.glsl"
#include "common/srgb.glsl"
#include "common/terminator.glsl"

in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;

uniform vec3 u_eye;
uniform vec3 u_light;
uniform float u_shininess;
uniform sampler2D s_albedo;
#ifdef NORMAL_MAP
in vec4 v_tangent;
uniform float u_strength;
uniform sampler2D s_normal;
#endif

layout(location = 0) out vec4 o_color;

vec3 direction() {
#ifdef NORMAL_MAP
    return direction_of_texel(texture(s_normal, v_uv).xyz, u_strength);
#else
    return vec3(0.0, 0.0, 1.0);
#endif
}

//(normal
vec3 surface_normal() {
#ifdef NORMAL_MAP
    return direction_in_world(direction(), v_tangent.xyz, v_tangent.w * cross(v_normal, v_tangent.xyz), v_normal);
#else
    return normalize(v_normal);
#endif
}
//)

// The light that a normal map reflects. It turns normals, but casts no shadow.
vec3 reflected(vec3 albedo, vec3 normal, vec3 to_light, vec3 to_eye) {
    vec3 base = normalize(v_normal);
#ifdef TERMINATOR_SCHUESSLER
    return blinn_phong_on_facets(albedo, 0.16, u_shininess, base, normal, to_light, to_eye);
#else
#ifdef GGX
    vec3 light = ggx(albedo, 0.16, u_shininess, normal, to_light, to_eye);
#else
    vec3 light = blinn_phong(albedo, 0.16, u_shininess, normal, to_light, to_eye);
#endif
#if defined TERMINATOR_STEP
    light *= step(0.0, dot(base, to_light));
#elif defined TERMINATOR_CHIANG
    light *= chiang_shadow(base, normal, to_light);
#endif
    return light;
#endif
}

void main() {
#ifdef PROBE_direction
    o_color = probed(vec4(direction(), 0.0));
    return;
#endif
    vec3 normal = surface_normal();
#if defined LAMP
    o_color = vec4(1.0, 0.95, 0.84, 1.0);
#elif defined PROBE_normal
    o_color = probed(vec4(normal, 0.0));
#elif defined PROBE_uv
    o_color = vec4(v_uv * vec2(textureSize(s_albedo, 0)), 0.0, 0.0);
#else
    vec3 albedo = texture(s_albedo, v_uv).rgb;
    vec3 to_eye = normalize(u_eye - v_position), to_light = u_light - v_position;
    vec3 sky = mix(vec3(0.055, 0.045, 0.04), vec3(0.10, 0.125, 0.17), 0.5 + 0.5 * normal.y);
    vec3 lamp = vec3(1.0, 0.86, 0.68) * 9.0 / (1.0 + dot(to_light, to_light));
    vec3 light = albedo * sky + lamp * reflected(albedo, normal, normalize(to_light), to_eye);
    float haze = 1.0 - exp(-0.0016 * dot(u_eye - v_position, u_eye - v_position));
    vec3 seen = mix(light, vec3(0.0123, 0.0137, 0.0176), haze);
    o_color = finished(vec4(srgb_from_linear(seen), 1.0), gl_FragCoord.xy);
#endif
}
