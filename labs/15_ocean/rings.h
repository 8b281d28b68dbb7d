// The grid of lab 15's sea: rings around the place below the eye, out to the horizon. Near the eye waves raise it.
#pragma once

#include <optional>

#include "framework/core/gl/object.h"
#include "polar_grid.h"
#include "water.h"

namespace relief::ocean {

/// Returns whether some water in the picture is so near that flat water would be off by more than `budget` pixels.
bool are_waves_visible(const Frame& frame, const Water& water, double budget);

/// Returns the grid for a frame, without the patches outside of the picture. The detail of a vertex is the longest
/// segment there, as an exponent of 2 of metres. Flat water has few triangles.
PolarGrid grid_of(const Frame& frame, const Water& water, double budget, bool is_raised);

/// A grid on the GPU.
class Rings {
public:
    void fill(PolarGrid grid);
    /// Sets the uniforms of sea.vert, and draws the triangles, or their edges with `wire`. The sea has no end, so
    /// places are relative to the eye, in double precision up to here. Preconditions: fill(), and the program is in
    /// use.
    void draw(const Program& program, const Camera& camera, bool wire) const;

private:
    struct Buffers {
        VertexArrayName layout;
        BufferName vertices, indices;
    };
    PolarGrid grid_;
    std::optional<Buffers> buffers_;  ///< made by the first fill()
};

}  // namespace relief::ocean
