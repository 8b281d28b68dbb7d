// Skips to the wall of an empty cone that stands on the cell (Dummer 2006). Along the ray the wall rises and the ray
// falls.

uniform sampler2D s_cones;  // free radius of the cone above a cell's highest corner, texels per unit of height

float next_t(Look at) {
    vec2 size = vec2(textureSize(s_heights, 0));
    float top = max(max(at.corners.x, at.corners.y), max(at.corners.z, at.corners.w));
    float wall = length(at.ray.along) / texelFetch(s_cones, ivec2(mod(at.first + at.cell, size)), 0).r;
    float falls = -(at.ray.height.y + 2.0 * at.t * at.ray.height.z);
    return max(at.leaves, at.t + (height_of(at.ray, at.t) - top) / max(falls + wall, 1e-9));
}
