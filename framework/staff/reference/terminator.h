// The bump terminator: a normal map changes cosines, but casts no shadow. Published factors that guess the shadow from
// the normals, and the exact light of a relief.
#pragma once

#include <glm/glm.hpp>

#include "framework/staff/reference/height_field.h"

namespace relief {

/// Both return a factor on the light, from 0 to 1, for unit vectors: the normal of the base, the normal of the map, and
/// the direction to the light. A light below the base gives 0. Finite for all unit vectors.
///
/// Estevez, Lecocq and Ebelin, "A microfacet-based shadowing function to solve the bump terminator problem", Ray
/// Tracing Gems, 2019.
double estevez_shadow(const glm::dvec3& surface, const glm::dvec3& mapped, const glm::dvec3& to_light);
/// Chiang, Li and Burley, "Taming the shadow terminator", SIGGRAPH Talks, 2019.
double chiang_shadow(const glm::dvec3& surface, const glm::dvec3& mapped, const glm::dvec3& to_light);

/// The mean light of a tile of a relief that repeats, seen from above: means over the area of the base of
/// factor * max(0, n . to_light).
struct TileLight {
    double clamped = 0;  ///< no factor
    double estevez = 0, chiang = 0;
    double flat = 0;   ///< without a normal map
    double exact = 0;  ///< with the relief's own shadow
    /// The mean of visible * (n . to_light) / n.z. It is to_light.z for every relief: what reaches the tile falls
    /// through its base.
    double flux = 0;
};
/// Returns it from samples x samples places in the middles of equal squares. A height of 1 is `depth` texels high.
/// `to_light` is a unit vector with z > 0.
TileLight tile_light(const HeightField& heights, double depth, const glm::dvec3& to_light, int samples);

/// Returns six sines with whole numbers of periods along a tile of side x side texels, in [0, 1].
Image sine_relief(int side);

}  // namespace relief
