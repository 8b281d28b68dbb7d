// A square patch of a ground with skirts: strips that hang from its borders and hide gaps beside a coarser neighbour.
#pragma once

#include <cstdint>
#include <vector>

namespace relief {

/// The vertices are those of the grid, row by row, then the lower ends of the skirts: quads + 1 along each of the four
/// borders, around the patch.
struct SkirtedPatch {
    int quads;  ///< along each side, at least 1

    int grid_vertices() const { return (quads + 1) * (quads + 1); }
    int skirt_vertices() const { return 4 * (quads + 1); }
    int vertices() const { return grid_vertices() + skirt_vertices(); }
    /// Returns the grid's vertex from which the skirt's vertex i hangs. i is in [0, skirt_vertices()).
    int hangs_from(int i) const;
    int grid_indices() const { return 6 * quads * quads; }
    /// Returns the triangles, counter-clockwise: the grid_indices() of the grid, then those of the skirts, seen from
    /// outside of the patch.
    std::vector<uint32_t> indices() const;
};

}  // namespace relief
