#version 410 core
// The surface of the water. A vertex reads the mip level of the height map that fits its segments. Far away segments
// are longer than the waves, so the sea becomes flat by itself.

#include "15_ocean/maps.glsl"

layout(location = 0) in vec3 a_polar;  // radius, angle, exponent of 2 of the longest segment

uniform mat4 u_clip_from_eye;
uniform float u_eye_height;
uniform float u_near;

out vec3 v_place;  // metres from the eye along x and z; height

float height_at(vec2 place, float segment) {
    float sum = 0.0;
#ifndef FLAT
#ifdef FIRST
    sum += u_amplitude.x * textureLod(s_waves_1, map_uv(place, 0), level_of(segment, 0)).z;
#endif
#ifdef SECOND
    sum += u_amplitude.y * textureLod(s_waves_2, map_uv(place, 1), level_of(segment, 1)).z;
#endif
#endif
    return sum;
}

void main() {
    // `precise` makes both patches at an edge compute the same bits for its vertices.
    precise vec2 place = a_polar.x * vec2(sin(a_polar.y), cos(a_polar.y));
    precise float height = height_at(place, exp2(a_polar.z));
    v_place = vec3(place, height);
    // There is no far plane.
    gl_Position = u_clip_from_eye * vec4(place.x, height - u_eye_height, place.y, 1.0);
    gl_Position.z = gl_Position.w - 2.0 * u_near;
}
