// From cell to cell along a ray over a height map, so that it cannot stall.
//
// Cells are counted, in whole numbers along the ray's way from the one that it starts in: cell `passed` of the count
// lies way * passed cells from there. A float holds whole numbers exactly up to 2^24, so a cell's walls stay where
// they are however far the ray has come; its t may be rounded, and each iteration still goes on by a cell at least.

// A pixel gets no more, whatever it looks for: Mesa 22.3's software renderer ends its loops after 65,535 in all.
const int max_iterations = 65000;

// As many as a ray needs from t0 to t1 without a skip: one for each wall, and one for each end.
int iterations_between(vec2 along, float t0, float t1) {
    return int(min((abs(along.x) + abs(along.y)) * (t1 - t0), float(max_iterations))) + 4;
}

// 1 or -1 along each axis.
vec2 way_of(vec2 along) { return mix(vec2(-1.0), vec2(1.0), greaterThanEqual(along, vec2(0.0))); }

// Where a ray starts in its cell, counted along its way.
vec2 start_along(vec2 start, vec2 way) { return mix(1.0 - start, start, greaterThan(way, vec2(0.0))); }

// The cell after `passed`, whose walls ahead the ray reaches at leaves.x and leaves.y: through the one that it
// reaches first. Or a later cell, where it has skipped to `place`; on a line between two that is the one it enters.
// The ten-thousandth of a cell is for speed: without it a ray that was rounded to just before a line looks at the
// cell behind once more.
//(next
vec2 next_cell(vec2 passed, vec2 leaves, vec2 place) {
    return max(passed + vec2(lessThanEqual(leaves, leaves.yx)), floor(place + 1e-4));
}
//)
