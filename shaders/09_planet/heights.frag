#version 410 core
// The heights of a patch's texels, of its gutter, and of one more texel on each side.

#include "09_planet/grid.glsl"
#include "09_planet/heights.glsl"

uniform mat3 u_face;
uniform ivec2 u_patch;
uniform int u_level;
uniform int u_texels;
uniform ivec2 u_corner;  // of the patch's tile, pixels

layout(location = 0) out vec4 o_height;

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy) - u_corner - 1;
#ifdef NO_GUTTER
    texel = clamp(texel, ivec2(1), ivec2(u_texels));
#endif
    vec3 r = grid_direction(u_face, gutter_place(texel, u_patch, u_level, u_texels));
    float elevation_ = elevation(r);
    o_height = vec4(height_of_elevation(elevation_), elevation_, 0.0, is_unfinished ? 0.0 : 1.0);
}
