// One cell of a height map: the bilinear surface between four texel centres, and its intersection with a ray.
//
// The corners have textureGather's order: x = h01, y = h11, z = h10, w = h00. h10 is one texel from h00 along u, and
// h01 one texel along v. Positions in the cell go from (0, 0) at h00 to (1, 1) at h11.

// Returns the corners of the cell whose lower left texel is `cell`, on level 0. Gathers at the cell's centre, where the
// choice of the four texels is unambiguous.
vec4 cell_corners(sampler2D heights, ivec2 cell) {
    return textureGather(heights, (vec2(cell) + 1.0) / vec2(textureSize(heights, 0)));
}

float height_in_cell(vec4 corners, vec2 at) {
    vec2 along_v = mix(corners.wz, corners.xy, at.y);
    return mix(along_v.x, along_v.y, at.x);
}

// Returns dh/du and dh/dv, per texel.
vec2 slope_in_cell(vec4 corners, vec2 at) {
    return vec2(mix(corners.z - corners.w, corners.y - corners.x, at.y),
                mix(corners.x - corners.w, corners.y - corners.z, at.x));
}

// Returns the height of a straight segment above the surface, as Bernstein coefficients:
// x (1 - s)^2 + 2 y s (1 - s) + z s^2. s runs from 0 to 1 along the segment. The ends have cell positions in xy and
// heights in z.
vec3 gap_above_cell(vec4 corners, vec3 from, vec3 to) {
    float mixed = height_in_cell(corners, vec2(to.x, from.y)) + height_in_cell(corners, vec2(from.x, to.y));
    return vec3(from.z - height_in_cell(corners, from.xy), 0.5 * (from.z + to.z - mixed),
                to.z - height_in_cell(corners, to.xy));
}

//(closes
// Returns whether a gap that begins at or above 0 reaches 0. Needs no root and no division.
bool closes(vec3 gap) {
    return gap.z <= 0.0 || gap.x <= 0.0 || (gap.y < 0.0 && gap.y * gap.y >= gap.x * gap.z);
}

// Returns the first s at which a gap that closes is 0. Both forms of the root add numbers of one sign, so nothing
// cancels.
float first_closing(vec3 gap) {
    if (gap.x <= 0.0) return 0.0;
    float root = sqrt(max(0.0, gap.y * gap.y - gap.x * gap.z));
    return gap.y > 0.0 ? (gap.y + root) / (gap.y + root - gap.z) : gap.x / (gap.x - gap.y + root);
}
//)
