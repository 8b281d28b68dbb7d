// The models of lab 07: an ammonite with a formula, fine and coarse, and a cube whose normals are averaged.
//
// The ammonite's tube winds three times around the z axis and grows by `growth` a turn; its whorls are neighbours, so
// what reaches out from one may meet another.
#pragma once

#include "framework/lab/lab.h"

namespace relief::baking {

enum class Shape { ammonite, mirrored, cube };

constexpr int whorls = 3;
constexpr double growth = 2.1, outer_radius = 0.74;              ///< of the centre line at turn 3, metres
constexpr double touching_radius = (growth - 1) / (growth + 1);  ///< of the tube, in radii of the centre line
constexpr double rib_height = 0.15, growth_line_height = 0.012;  ///< in radii of the tube
constexpr double cord_height = 0.28, cord_radius = 0.08;         ///< of its middle over the tube; the same
constexpr float cube_side = 1.05f;
constexpr glm::vec3 cube_centre{0.17f, 0, 0};  // where the ammonite has its middle

struct Model {
    Shape shape = Shape::ammonite;
    float gap = 0.12f;  ///< share of the tube's radius that is left free between neighbours
    bool operator==(const Model&) const = default;

    /// Of the centre line at a turn from 0 to 3, and of the tube there.
    double centre_radius(double turn) const;
    double tube_radius(double turn) const;
    /// What distances at a place of the map are measured in: the tube's radius, or half of the cube's side.
    double unit(const glm::dvec2& uv) const;
};

/// `columns` along the tube and `sides` around it. Growth lines are on meshes that are fine enough for them.
struct Fineness {
    int columns, sides;
};
constexpr std::array<Fineness, 3> high_finenesses = {{{340, 24}, {728, 90}, {2048, 256}}};
/// Of one whorl.
constexpr std::array<Fineness, 3> low_finenesses = {{{4, 4}, {14, 6}, {28, 12}}};

/// The mesh that is baked. uv.x is the turn at a vertex, so that a hit knows its whorl; on the cord, 100 more. The cord
/// runs above the last whorl without touching it. The cube has a normal for each face.
Mesh make_high(const Model& model, Fineness fineness, bool cord);

/// The mesh that wears the map: vertices on the tube without its ribs, with the tube's own normals. Each whorl is a
/// strip of the map, each face of the cube a square; all borders lie on multiples of 1/16. `overlapping`: the inner two
/// whorls share a strip. `other_diagonal` cuts each quad the other way. The cube's normals are averaged over three
/// faces.
Mesh make_low(const Model& model, Fineness fineness, bool overlapping, bool other_diagonal);

/// The turn at a place of the map.
double turn_at(const glm::dvec2& uv);

/// How far a cage must be from the low mesh so that no ray begins inside of the high one, in radii of the tube: relief
/// and both sagittas.
double reach_needed(const Model& model, Fineness low);

}  // namespace relief::baking
