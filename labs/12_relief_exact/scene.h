// The scene of lab 12: reliefs at their places, and a ball among them.
#pragma once

#include <glm/gtc/matrix_transform.hpp>

#include "framework/kit/relief_surface.h"
#include "framework/lab/lab.h"

namespace relief::exact {

/// One relief. On a cylinder the relief's own outline is that of a base which bends; a wall ends where its uv do.
struct Object {
    const ReliefSurface* surface;
    glm::dmat4 world_from_model{1};

    /// From the front alone: a far half's base is nearer than some of what the near half's view rays hit.
    bool is_closed() const { return surface->shape != ReliefSurface::wall; }
    double radius(bool outline) const {
        return outline && surface->shape == ReliefSurface::column ? double(ReliefSurface::column_radius) : 0;
    }
    /// Between which uv there is a surface.
    std::pair<glm::vec2, glm::vec2> border(bool outline) const {
        const glm::vec2 far(1e30f);
        if (!outline || surface->shape == ReliefSurface::urn) return {-far, far};
        const ReliefMapping mapping = surface->mapping();
        glm::vec2 low = glm::min(mapping.shift, mapping.shift + mapping.repeat),
                  high = glm::max(mapping.shift, mapping.shift + mapping.repeat);
        if (surface->shape == ReliefSurface::column) {  // it closes around
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
