// The bounds of a patch in s_patches: a row is a texel of four floats. PatchTexture (labs/14_adaptive_displacement)
// writes the rows, and patch.tesc reads them. Both include this file.

const int row_heights = 0;    // the lowest and the highest height, spread of the directions, 0
const int row_sphere = 1;     // around the corners: centre and radius
const int row_axis = 2;       // the axis, and flat_rise
const int row_steepness = 3;  // rise, shift, skew, length: with flat_rise, members of Facing in labs/14_adaptive_displacement/facing.h
// Two rows for the inside and for each edge: errors of levels 1, 2, 4, 8; errors of levels 16, 32, 64, and the mean of
// the lowest and the highest height.
const int row_inside = 4, row_edges = 6;
const int rows_a_patch = 14;
const int patches_a_line = 64;  // in a line of the texture
