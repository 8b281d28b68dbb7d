#version 410 core
// The angle in degrees between the vectors of two textures, or the distance of their values, as a colour. Nothing where
// either has no surface: see framework/library/kit/difference_map.h.

#include "common/heat.glsl"

uniform sampler2D s_measured, s_exact;
uniform ivec2 u_corner;  // of the tile
uniform vec2 u_powers;   // of ten, at the ends of the scale

layout(location = 0) out vec4 o_color;

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy) - u_corner;
    vec3 measured = texelFetch(s_measured, texel, 0).xyz, exact = texelFetch(s_exact, texel, 0).xyz;
    vec3 sum = measured + exact;
    if (any(isinf(sum)) || any(isnan(sum))) discard;
#ifdef ANGLE
    float off = degrees(atan(length(cross(measured, exact)), dot(measured, exact)));
#else
    float off = distance(measured, exact);
#endif
    o_color = vec4(log_heat(off, u_powers.x, u_powers.y), 1.0);
}
