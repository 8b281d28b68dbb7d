// Numbers that the baker's C++ and GLSL share: both include this file.

const int row_bits = 10;   // a texture of data has 2^row_bits texels a row
const int node_radix = 8;  // a node stores node_radix * first + count of its triangles
const int take_nearest = 0, take_first = 1, take_last = 2;  // which hit counts
