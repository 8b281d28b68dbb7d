// The masks of lab 08 as formulas: a wire fence and an ivy, at any position, without texels.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>

namespace relief {

/// Chain link: straight wires along both diagonals, `wires` of each in a tile. Not a power of two, so that mip levels
/// do not become uniform.
constexpr int wires = 7;
constexpr double wire_coverage = 0.12;  ///< exact share of the tile that is wire
bool is_wire(const glm::dvec2& uv);

/// The topmost leaf at a position of the ivy.
struct Leaf {
    int number;
    glm::dvec2 place;  ///< in the leaf: x across, from -1 to 1; y from 0 at the stalk to 1 at the tip
};

/// Returns the topmost leaf, if any. The ivy tiles in u. From v = 0 to 1 it thins out: dense at the foot, single leaves
/// at the top, none at the border.
std::optional<Leaf> leaf_at(const glm::dvec2& uv);

/// Returns the share of a tile that is leaf, over 1024 x 1024 samples.
double leaf_coverage();

}  // namespace relief
