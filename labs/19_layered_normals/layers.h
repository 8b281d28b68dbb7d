// The two layers of lab 19, the same on every machine: large stones with joints, and a grain.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "framework/core/image/image.h"

namespace relief::layered_normals {

/// A height with its first and second derivatives, in tiles. A tile is the unit square, and repeats.
struct Height {
    double height;
    glm::dvec2 slope;  ///< along u and v
    glm::dvec3 bend;   ///< second derivatives: uu, uv, vv
};

/// Four courses of cut stones. Slopes are below 1.5. The first derivatives are continuous.
Height stones(glm::dvec2 uv);
/// A sum of waves of random directions, with at least 4 and at most 28 periods per tile. Slopes are below 1.5, with a
/// root mean square of 0.4.
Height grain(glm::dvec2 uv);

constexpr int texels = 512;  ///< along a side of the maps of a layer

/// The maps of a layer: four floats for each texel, from the layer at its centre.
struct LayerMaps {
    Image normals;  ///< unit normal, and the height
    Image slopes;   ///< slopes along u and v, and their squares
    Image bends;    ///< product of the slopes, and the second derivatives uu, uv, vv
};
/// Returns u and v of a texel's centre. Row 0 is the top, and v grows up.
inline glm::dvec2 centre_of_texel(int x, int y) { return {(x + 0.5) / texels, 1 - (y + 0.5) / texels}; }

/// Return the maps of both layers. The first call makes them, which takes some 100 ms.
const LayerMaps& stone_maps();
const LayerMaps& grain_maps();

}  // namespace relief::layered_normals
