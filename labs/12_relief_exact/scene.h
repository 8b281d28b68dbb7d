// The scene of lab 12: reliefs, and a ball among them.
#pragma once

#include <glm/gtc/matrix_transform.hpp>

#include "framework/core/lab/lab.h"
#include "framework/library/kit/relief_surface.h"

namespace relief::exact {

/// One relief of the scene. With `outline` a relief has an exact outline: a column's base bends, and surfaces end at
/// the border of their uv.
struct Object {
    const ReliefSurface* surface;
    glm::dmat4 world_from_model{1};

    /// Returns whether the shape is closed. Then cull back faces: their base would hide valid hits on the near half.
    bool is_closed() const { return surface->shape != ReliefSurface::wall; }
    /// Returns the radius of the cylinder that the base is, in metres; 0 for a flat base.
    double radius(bool outline) const {
        return outline && surface->shape == ReliefSurface::column ? double(ReliefSurface::column_radius) : 0;
    }
    /// Returns the lowest and the highest uv of the surface; +-1e30 without a border.
    std::pair<glm::vec2, glm::vec2> border(bool outline) const {
        const glm::vec2 far(1e30f);
        if (!outline || surface->shape >= ReliefSurface::urn) return {-far, far};  // the urn, and a file
        const ReliefMapping mapping = surface->mapping();
        glm::vec2 low = glm::min(mapping.shift, mapping.shift + mapping.repeat),
                  high = glm::max(mapping.shift, mapping.shift + mapping.repeat);
        if (surface->shape == ReliefSurface::column) {  // it has no border along u
            low.x = -far.x;
            high.x = far.x;
        }
        return {low, high};
    }
};

struct Ball {
    glm::dvec3 centre{0.62, 0.06, 0.42};
    double radius = 0.3;
};

}  // namespace relief::exact
