// The masks of lab 08 as formulas: where a wire fence and an ivy are, at any place, without texels.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>

namespace relief {

/// Chain link: straight wires along both diagonals, `wires` of each to the tile; not a power of two, so that mip levels
/// do not become even.
constexpr int wires = 7;
constexpr double wire_coverage = 0.12;  ///< share of the tile that is wire, exactly
bool is_wire(const glm::dvec2& uv);

/// A leaf that lies on top at a place of the ivy.
struct Leaf {
    int number;
    glm::dvec2 place;  ///< in the leaf: x across, from -1 to 1; y from the stalk, 0, to the tip, 1
};

/// Tiles in u. From v = 0 to 1 it thins out: dense at its foot, single leaves at its top, none at its border.
std::optional<Leaf> leaf_at(const glm::dvec2& uv);

/// Share of a tile that is leaf, over 1024 x 1024 places.
double leaf_coverage();

}  // namespace relief
