// A mesh in textures (labs/07_baking/ray_mesh.h). C++ and GLSL both include this file. The textures:
//  - s_nodes, two texels per node: low, next node after a miss; high, node_radix * first + count of its triangles
//  - s_corners, three texels per triangle: position, number of the vertex
//  - s_normals, one texel per vertex: normal, u
// Texel i is in row i / 2^row_bits.

const int row_bits = 10;
const int node_radix = 8;
