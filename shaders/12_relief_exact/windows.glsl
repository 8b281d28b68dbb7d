// Skips to the place where the ray leaves the best of four windows ahead of its block, or comes down to its maximum.

uniform sampler2DArray s_windows;  // see height_windows(): layer = octant, texel = block, channel = window
uniform mat4 u_window_extent;        // cells that each window reaches beyond the block
uniform float u_block, u_per_block;  // cells along a block's side, and its reciprocal

vec4 beyond_u, beyond_v;  // the change of t across these cells, along u and along v
void prepare(vec2 per_cell, float octant) {
    int axis = octant < 4.0 ? 0 : 2;
    beyond_u = u_window_extent[axis] * per_cell.x, beyond_v = u_window_extent[axis + 1] * per_cell.y;
}

//(windows
float next_t(Look at) {
    vec2 place = at.first + at.cell, low = floor(place * u_per_block) * u_block - at.first;
    vec2 out_of_block = leave_square(at.ray, at.inverse, low, u_block);
    vec4 out_of_window = min(out_of_block.x + beyond_u, out_of_block.y + beyond_v);
    vec4 clearance = textureLod(s_windows, vec3((place + 0.5) * at.texel, at.octant), 0.0);
    return next_look(at.leaves, out_of_window, above_until(at, clearance));
}
//)
