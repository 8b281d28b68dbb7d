// The surroundings of a lab's objects, as in a photographer's studio: a floor with the objects' soft shadow, and a
// backdrop above it.
#pragma once

#include <functional>
#include <map>
#include <vector>

#include "framework/core/base/mesh.h"
#include "framework/core/lab/lab.h"
#include "framework/library/kit/tiles.h"
#include "framework/library/kit/window_triangle.h"

namespace relief {

/// A small piece of a surface. The length of `area` is its area in square metres, along the normal.
struct Facet {
    glm::dvec3 place, area;
};

/// Returns the facets of a mesh in the world. Near triangles that face one way become one facet with the sum of their
/// areas, so that at most some hundred facets remain.
std::vector<Facet> facets_of(const Mesh& mesh, const glm::dmat4& world_from_model = glm::dmat4(1));

/// Returns the share of an even sky's light that the facets take from a place on a level floor: the sum of their form
/// factors, at most 1. A closed surface hides the same by its front and by its back; the larger sum counts.
double hidden_sky(const std::vector<Facet>& facets, const glm::dvec3& place);

class Studio {
public:
    /// Draws floor and backdrop in a tile where no depth was written, if the frame has a studio. `make` returns the
    /// mesh that stands on the floor with its lowest vertex. It is called for inputs that were not drawn lately.
    /// `frame` is the tile's, as for the mesh. Sets the viewport. Preconditions: the framebuffer is bound, and the
    /// depth test is on.
    void draw(const Frame& frame, const Tile& tile, std::vector<double> inputs, const std::function<Mesh()>& make,
              const glm::dmat4& world_from_model = glm::dmat4(1));

private:
    struct Floor {
        glm::dvec3 middle;  ///< of the shadow, on the floor
        double radius;      ///< half the diagonal of the box around the mesh, metres
        Texture shadow;
    };
    static Floor floor_under(const Mesh& mesh, const glm::dmat4& world_from_model);

    Programs program_{"common/far_window.vert", "common/studio.frag"};
    std::map<std::vector<double>, Floor> floors_;  ///< by inputs
    WindowTriangle window_;
};

}  // namespace relief
