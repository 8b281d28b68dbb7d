// Baking in double precision: the places of a coarse mesh's texels, the hits of their rays on a fine one, and whole
// maps.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "framework/core/base/mesh.h"
#include "framework/core/image/image.h"
#include "framework/library/mesh/tree.h"

namespace relief {

/// A place on the coarse mesh, interpolated between the corners of its triangle. Normal and tangent are not normalised.
struct BakePlace {
    glm::dvec3 position{}, normal{};
    glm::dvec4 tangent{};
    glm::dvec2 uv{};
    double cover = 0;  ///< number of triangles that cover it on the map
};

/// Returns the place with these barycentric weights, without a cover.
BakePlace place_at(const Mesh& mesh, size_t triangle, const glm::dvec3& weights);

/// Returns the places of the texels of `rows` rows of a map, from row `first_row` on; row 0 is at the top. A texel
/// belongs to the triangle that covers its centre, or to one of two triangles if its centre is on their common edge.
/// The last of several triangles has it. `cover` is 0 where there is none.
std::vector<BakePlace> texel_places(const Mesh& mesh, glm::ivec2 size, int first_row, int rows);
/// Returns the places of the whole map.
std::vector<BakePlace> texel_places(const Mesh& mesh, glm::ivec2 size);

struct BakeHit {
    double height;      ///< above the place, along its normal; in the meshes' units
    glm::dvec3 normal;  ///< of the fine mesh, unit
};
/// Returns the hit that is nearest to the place, on the ray along its normal from `reach` above it to `reach` below.
/// Only front faces count. Returns nothing if there is none.
std::optional<BakeHit> nearest_hit(const TriangleTree& fine_tree, const Mesh& fine, const BakePlace& place,
                                   double reach);

enum class BakeStore {
    tangent,  ///< normals in the frame as interpolated, which is that of MikkTSpace: see interpolated_frame()
    object,   ///< normals in the meshes' own space
    heights,  ///< heights above the coarse mesh, in the meshes' units
};

struct BakeOptions {
    BakeStore store = BakeStore::tangent;
    glm::ivec2 size{1024};
    double reach = 0;  ///< in the meshes' units
    /// Is called before each part of the work, with its index and the number of parts.
    std::function<void(int part, int parts)> before_part = {};
};

/// Values, not yet encoded: unit normals in 3 channels, or heights in one.
struct BakedMap {
    Image values;
    size_t hit = 0, missed = 0, filled = 0;  ///< numbers of texels; together all
    size_t covered_twice = 0;                ///< texels in which islands overlap
    double largest_distance = 0;             ///< of a hit from the coarse mesh
};

/// Bakes with a ray through the centre of each texel. A covered texel whose ray misses gets the coarse mesh's own
/// normal, or height 0. So does one where the interpolated normal is zero; its normal is +z. Other texels are filled
/// from the islands outwards, texel by texel, with the mean of those neighbours, of eight, that have a value, until
/// none is left. Precondition: the coarse mesh has normals, tangents and uv. Throws Error if a uv is not in [0, 1], or
/// no texel is covered.
BakedMap bake(const Mesh& fine, const Mesh& coarse, const BakeOptions& options);

}  // namespace relief
