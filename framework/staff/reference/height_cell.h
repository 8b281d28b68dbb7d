// One cell of a height map: the bilinear surface between four texel centres, and its intersection with a ray. The twin
// of shaders/common/height_cell.glsl.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace relief {

/// The heights of four neighbouring texels. h10 lies one texel from h00 along u, h01 one texel along v. Positions in
/// the cell go from (0, 0) at h00 to (1, 1) at h11.
struct HeightCell {
    double h00, h10, h01, h11;

    double top() const { return std::max(std::max(h00, h10), std::max(h01, h11)); }
};

inline double height_in_cell(const HeightCell& cell, glm::dvec2 at) {
    const double lower = cell.h00 + (cell.h10 - cell.h00) * at.x, upper = cell.h01 + (cell.h11 - cell.h01) * at.x;
    return lower + (upper - lower) * at.y;
}

/// Returns dh/du and dh/dv, per texel.
inline glm::dvec2 slope_in_cell(const HeightCell& cell, glm::dvec2 at) {
    const double along_u = cell.h10 - cell.h00, along_v = cell.h01 - cell.h00;
    const double twist = (cell.h11 - cell.h01) - along_u;
    return {along_u + twist * at.y, along_v + twist * at.x};
}

/// The height of a straight segment above the cell's surface, as a quadratic in Bernstein form:
/// begin (1 - s)² + 2 middle s (1 - s) + end s². s runs from 0 to 1 along the segment.
struct Gap {
    double begin, middle, end;
};

/// Returns the gap of a segment between two points; x and y are positions in the cell, z is a height. Because the
/// surface is bilinear, the middle coefficient has a closed form. It is the segment's mean height minus the mean of the
/// surface at the two mixed positions (x of one end, y of the other).
inline Gap gap_above_cell(const HeightCell& cell, glm::dvec3 from, glm::dvec3 to) {
    return {from.z - height_in_cell(cell, {from.x, from.y}),
            (from.z + to.z - height_in_cell(cell, {to.x, from.y}) - height_in_cell(cell, {from.x, to.y})) / 2,
            to.z - height_in_cell(cell, {to.x, to.y})};
}

/// Returns whether a gap that begins at or above 0 reaches 0. Needs no root and no division.
inline bool closes(const Gap& gap) {
    return gap.end <= 0 || gap.begin <= 0 || (gap.middle < 0 && gap.middle * gap.middle >= gap.begin * gap.end);
}

/// Returns the first s in [0, 1] at which the gap is 0. Precondition: closes(gap). s / (1 - s) is the smaller positive
/// root of begin + 2 middle r + end r². Both forms of the root add numbers of one sign, so nothing cancels.
inline double first_closing(const Gap& gap) {
    if (gap.begin <= 0) return 0;
    const double root = std::sqrt(std::max(0.0, gap.middle * gap.middle - gap.begin * gap.end));
    if (gap.middle > 0) return (gap.middle + root) / (gap.middle + root - gap.end);
    return gap.begin / (gap.begin - gap.middle + root);
}

}  // namespace relief
