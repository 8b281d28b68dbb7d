// The grid of lab 15's sea: rings around the place below the eye, out to the horizon. Near the eye waves raise it.
#pragma once

#include <optional>
#include <vector>

#include "framework/core/gl/object.h"
#include "framework/core/kit/view_axes.h"
#include "water.h"

namespace relief::ocean {

/// A vertex of the sea.
struct RingVertex {
    float radius, angle;  ///< metres and radians, around the place below the eye
    float exponent;       ///< of 2: the longest segment there, metres
};

/// Triangles between the vertices. Neighbouring patches share the values of all vertices on their common edge.
struct RingGrid {
    std::vector<RingVertex> vertices;
    std::vector<unsigned> indices;
};

class Rings {
public:
    bool displace = true;
    float budget = 3;  ///< error of the raised waves, pixels

    /// Returns whether some water in the picture is so near that flat water would exceed the budget.
    bool are_raised(const Frame& frame, const Water& water) const;

    /// Returns the grid for a frame, without the patches outside of the picture.
    RingGrid grid(const Frame& frame, const Water& water, bool is_raised) const;

    /// Sets the uniforms of sea.vert, and draws the triangles, or their edges with `wire`. The sea has no end, so
    /// places are relative to the eye, in double precision up to here. Precondition: the program is in use.
    void draw(const Program& program, const Frame& frame, const Water& water, bool is_raised, bool wire);

private:
    /// Returns the error in metres that covers the budget in pixels, at a distance in metres.
    double tolerated(const Frame& frame, double distance) const;

    struct Buffers {
        VertexArrayName layout;
        BufferName vertices, indices;
    };
    std::optional<Buffers> buffers_;  ///< made by the first draw()
};

}  // namespace relief::ocean
