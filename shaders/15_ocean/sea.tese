#version 410 core
// The surface of the water. A vertex reads the mip level of the height map that fits its segments. Far away segments
// are longer than the waves, so the sea becomes flat by itself.

#include "15_ocean/maps.glsl"

layout(quads, fractional_odd_spacing, ccw) in;

in vec3 c_polar[];

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
    precise float radius = mix(c_polar[0].x, c_polar[3].x, gl_TessCoord.y);
    precise float angle = mix(c_polar[0].y, c_polar[1].y, gl_TessCoord.x);
    precise float segment = exp2(mix(c_polar[0].z, c_polar[3].z, gl_TessCoord.y));
    precise vec2 place = radius * vec2(sin(angle), cos(angle));
    precise float height = height_at(place, segment);
    v_place = vec3(place, height);
    // There is no far plane.
    gl_Position = u_clip_from_eye * vec4(place.x, height - u_eye_height, place.y, 1.0);
    gl_Position.z = gl_Position.w - 2.0 * u_near;
}
