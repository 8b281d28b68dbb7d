#version 410 core
// A patch relative to the eye. With LOG_DEPTH fragments write the depth. Then the near and far planes of clip space
// only cut off places behind the eye.

layout(location = 0) in vec4 a_place;  // from the patch's middle, radii; w is 1 at the lower end of a skirt
layout(location = 1) in vec2 a_local;  // on the patch, 0 to 1

uniform vec3 u_middle;
uniform vec3 u_minus;
uniform vec3 u_centre;  // the patch's middle from the planet's centre, radii
uniform float u_radius;
uniform float u_skirt;  // metres
uniform mat3 u_view_from_world;
uniform vec2 u_zoom;
uniform float u_near;

out vec3 v_from_eye;
out vec2 v_local;
out float v_away;
out vec4 v_air;
uniform vec3 u_eye;
#include "09_planet/air.glsl"
#ifdef VERTEX_NORMALS
#include "09_planet/map.glsl"
out vec3 v_normal;
#endif

void main() {
    v_from_eye = u_middle + a_place.xyz * u_radius - u_minus;
#ifdef SKIRTS
    v_from_eye -= a_place.w * u_skirt * normalize(u_centre + a_place.xyz);
#endif
    v_local = a_local;
    vec3 seen = u_view_from_world * v_from_eye;
    v_away = -seen.z;
    float distance_ = length(v_from_eye) / u_radius;
    v_air.xyz = air_light(u_eye, v_from_eye / (u_radius * max(distance_, 1e-30)), distance_, 3, v_air.w);
    gl_Position = vec4(u_zoom * seen.xy, -seen.z - 2.0 * u_near, -seen.z);
#ifdef VERTEX_NORMALS
    v_normal = map_at(a_local).xyz;
#endif
}
