// The models of lab 07: an ammonite in closed form, fine and coarse, a cube with averaged normals, and files.
//
// The ammonite's tube winds three times around the z axis. It grows by the factor `growth` each turn. Whorls lie close
// together, so a ray that leaves one may hit another.
#pragma once

#include "framework/core/lab/lab.h"
#include "framework/library/kit/choices.h"
#include "framework/library/kit/own_mesh.h"

namespace relief::baking {

/// `own` is a file of the user, which has no name.
enum class Shape { ammonite, mirrored, cube, own };
inline constexpr auto shapes =
    choices<Shape>({{Shape::ammonite, "ammonite"}, {Shape::mirrored, "mirrored"}, {Shape::cube, "cube"}});

constexpr int whorls = 3;
constexpr double growth = 2.1, outer_radius = 0.74;              ///< of the centre line at turn 3, metres
constexpr double touching_radius = (growth - 1) / (growth + 1);  ///< of a touching tube, in radii of the centre line
constexpr double rib_height = 0.15, growth_line_height = 0.012;  ///< in radii of the tube
constexpr double cord_height = 0.28, cord_radius = 0.08;         ///< of its middle above the tube; in radii of the tube
constexpr float cube_side = 1.05f;
constexpr glm::vec3 cube_centre{0.17f, 0, 0};  // the middle of the ammonite
constexpr double own_radius = 0.95;            ///< half the diagonal of an own model's bounding box, metres

/// The map: strips of the whorls, or squares of the cube's faces, with borders around them. In uv.
constexpr double border = 1.0 / 16, strip = 1.0 / 4, step = strip + border;

struct Model {
    Shape shape = Shape::ammonite;
    float gap = 0.12f;  ///< between neighbouring whorls, a share of the tube's radius
    bool operator==(const Model&) const = default;

    /// Return the distance of the centre line from the axis, and the radius of the tube, in metres at a turn in [0, 3].
    double centre_radius(double turn) const;
    double tube_radius(double turn) const;
    /// Returns the unit of distances at a place of the map, in metres: the tube's radius, half of the cube's side, or
    /// an eighth of an own model's diagonal.
    double unit(const glm::dvec2& uv) const;
};

/// Changes of the fine ammonite by a sculptor; heights are in radii of the tube. The defaults change nothing.
struct Sculpt {
    float ribs = 1;   ///< factor on the height of the ribs
    float bulge = 0;  ///< height of a wide bulge on the last whorl, or below 0 the depth of a hollow there
    float dents = 0;  ///< depth of rows of round dents
    bool operator==(const Sculpt&) const = default;

    double highest() const;  ///< above the tube
    double deepest() const;  ///< below the tube
};

/// The number of quads: `columns` along the tube and `sides` around it, and the number of triangles as a knob's choice.
/// Only meshes that are fine enough have growth lines.
struct Fineness {
    int columns, sides;
    const char* name = "";

    size_t triangles(int tubes = 1) const { return size_t(columns * sides * 2 * tubes); }
};
constexpr std::array<Fineness, 3> high_finenesses = {{{340, 24, "16k"}, {728, 90, "131k"}, {2048, 256, "1M"}}};
/// For one whorl. The names are for all.
constexpr std::array<Fineness, 3> low_finenesses = {{{4, 4, "100"}, {14, 6, "500"}, {28, 12, "2000"}}};

/// Returns the mesh that is baked. uv.x is the turn at a vertex, so that a hit knows its whorl. On the cord it is 100
/// more. The cord runs above the last whorl without touching it. The cube has flat faces.
Mesh make_high(const Model& model, Fineness fineness, bool cord, const Sculpt& sculpt);

/// Returns the mesh that wears the map. Its vertices lie on the tube without ribs and have the tube's normals. Each
/// whorl is a strip of the map, and each face of the cube a square. The cube's
/// normals are averaged over three faces. With `overlapping` the inner two whorls share a strip. `other_diagonal` cuts
/// all quads along the other diagonal.
Mesh make_low(const Model& model, Fineness fineness, bool overlapping, bool other_diagonal);

/// Files of the user: the coarse model, and the fine one that is baked for it.
struct OwnModels {
    OwnMesh coarse{own_radius}, fine{own_radius};

    /// Returns the coarse model in the lab. Its tangents are the file's, or are computed if the file has none.
    Mesh low() const;
    /// Returns the fine model, which is moved and scaled as the coarse one; its uv are 0. Without a file it is the
    /// coarse model.
    Mesh high(bool has_fine) const;
};

/// Returns the turn at a place of the map, clamped to the strip of a whorl.
double turn_at(const glm::dvec2& uv);

/// Returns the distance of a cage from the low mesh, in radii of the tube, at which no ray begins inside the high mesh
/// or ends above it. It is the height or the depth of the relief plus the sagittas along and around the tube. Returns 0
/// for the cube and for files.
double reach_needed(const Model& model, Fineness low, const Sculpt& sculpt);

}  // namespace relief::baking
