// The bump terminator: a normal map changes cosines, but casts no shadow. Published factors that guess the shadow from
// the normals, and the exact light of a relief.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "framework/staff/reference/height_field.h"

namespace relief {

/// Both return a factor on the light, from 0 to 1, for unit vectors: the normal of the base, the normal of the map, and
/// the direction to the light. A light below the base gives 0. Finite for all unit vectors.
///
/// The shadowing function of Conty Estevez, Lecocq and Stein (2019).
double estevez_shadow(const glm::dvec3& surface, const glm::dvec3& mapped, const glm::dvec3& to_light);
/// The factor of Chiang, Li and Burley (2019).
double chiang_shadow(const glm::dvec3& surface, const glm::dvec3& mapped, const glm::dvec3& to_light);

/// The light of a normal that is one of two facets, as means over the mapped facet of the cosine of the light that
/// falls on it.
struct FacetLight {
    double direct = 0;    ///< straight from the lamp
    double mirrored = 0;  ///< by way of the other facet, a mirror
    double sum() const { return direct + mirrored; }
};
/// Returns it for unit vectors as in the factors above, seen from straight above the base.
///
/// The normal of the map alone is no surface: its normals do not add up to the base's. So a second facet stands upright
/// and faces it, as large as needed for that sum. Each facet hides a share of the other from the lamp: the visible
/// share is (base . L) (base . n) over the sum of both facets' positive cosines, the upright one's times the sine of
/// the tilt. Light that the upright facet mirrors reaches the mapped one if the way back is hidden (paths of the second
/// order). No light is lost: the sum is (base . L) (base . n), which does not depend on the direction of the tilt. A
/// light or a mapped normal that is not above the base gives 0. Finite for all unit vectors.
///
/// Source: Schüssler et al. 2017.
FacetLight schuessler_light(const glm::dvec3& surface, const glm::dvec3& mapped, const glm::dvec3& to_light);

/// The light of a relief, seen from above, by method. Of one place, or of a tile as means over the area of its base.
struct TileLight {
    double clamped = 0;  ///< max(0, n . to_light)
    double estevez = 0, chiang = 0, schuessler = 0;
    double flat = 0;   ///< without a normal map
    double exact = 0;  ///< with the relief's own shadow
    /// visible * (n . to_light) / n.z. Its mean is to_light.z for every relief: what reaches the tile falls through its
    /// base.
    double flux = 0;
};
/// Returns the light at samples x samples places in the middles of equal squares, row by row. A height of 1 is `depth`
/// texels high. `to_light` is a unit vector with z > 0.
std::vector<TileLight> place_lights(const HeightField& heights, double depth, const glm::dvec3& to_light, int samples);
/// Returns the mean over these places.
TileLight tile_light(const HeightField& heights, double depth, const glm::dvec3& to_light, int samples);

/// Returns six sines with whole numbers of periods along a tile of side x side texels, in [0, 1].
Image sine_relief(int side);

}  // namespace relief
