// Bricks that are repeated on each face of the grid, to show how the face is turned. Include grid.glsl before.

uniform sampler2D s_bumps;

const float bump_tiles = 4.0;  // along a face

// Returns the unit normal with the bumps at a place on a face. The slopes of the bumps by s and t become a gradient,
// like the slopes of heights.
vec3 bumped(vec3 normal, mat3 face, vec2 st) {
    vec3 bump = 2.0 * texture(s_bumps, bump_tiles * (0.5 * st + 0.5)).xyz - 1.0, u, v;
    grid_tangents(face, clamp(st, -0.999, 0.999), u, v);  // at a pole of latitude and longitude u is 0
    return normalize(normal - gradient(u, v, -bump.xy / max(bump.z, 0.1)));
}
