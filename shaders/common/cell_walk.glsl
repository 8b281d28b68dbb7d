// Walks from cell to cell along a ray over a height map, without stalling.
//
// Cells are counted along the ray's direction from the cell in which it starts. Cell `passed` lies way * passed cells
// from there. A float holds integers exactly up to 2^24, so the positions of a cell's walls stay exact however far the
// ray has come. Its t may be rounded, but each iteration advances by at least one cell.

// Maximum iterations of a pixel in any search: Mesa 22.3's software renderer ends loops after 65,535 iterations in all.
const int max_iterations = 65000;

// Returns the number of iterations from t0 to t1 without a skip: one for each wall, and one for each end.
int iterations_between(vec2 along, float t0, float t1) {
    return int(min((abs(along.x) + abs(along.y)) * (t1 - t0), float(max_iterations))) + 4;
}

// Returns 1 or -1 along each axis.
vec2 way_of(vec2 along) { return mix(vec2(-1.0), vec2(1.0), greaterThanEqual(along, vec2(0.0))); }

// Returns the octant of the directions that height_windows() has windows for: 1 for -u, 2 for -v, 3 for both, and 4 more
// for a ray that passes more cells along v than along u.
float octant_of(vec2 along, vec2 way) {
    return dot(vec3(1.0, 2.0, 4.0), vec3(max(-way, 0.0), float(abs(along.y) > abs(along.x))));
}

// Returns the start position within its cell, measured along the ray's direction.
vec2 start_along(vec2 start, vec2 way) { return mix(1.0 - start, start, greaterThan(way, vec2(0.0))); }

// Returns the cell after `passed`. The ray reaches the walls ahead at leaves.x and leaves.y and goes through the nearer
// one. If the ray has skipped to `place`, returns a later cell; on a line between two cells, the one that it enters.
// The offset 1e-4 is for speed: without it, a ray that is rounded to just before a line visits the cell behind it
// again.
//(next
vec2 next_cell(vec2 passed, vec2 leaves, vec2 place) {
    return max(passed + vec2(lessThanEqual(leaves, leaves.yx)), floor(place + 1e-4));
}
//)
