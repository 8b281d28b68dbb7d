// Bakes on the graphics card: the coarse model is drawn into its map, and a ray at each texel finds the fine one.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "framework/gl/texel_target.h"
#include "framework/kit/kept.h"
#include "framework/mesh/tree.h"
#include "models.h"

namespace relief::baking {

/// What makes a program use a frame: the first three also store in it.
inline constexpr std::array frame_defines = {"", "EACH_UNIT", "GRAM_SCHMIDT", "VERTEX_BITANGENT"};

/// All that a bake depends on. Numbers are places among a knob's choices.
struct Recipe {
    Model model;
    int high = 0, low = 1;
    bool cord = false, overlapping = false, object_space = false, rays_of_face = false;
    int frame = 0;  ///< interpolated, each-unit, gram-schmidt
    int take = 0;   ///< nearest, first, last
    float reach = 0.42f;
    int size = 256, bits = 0, padding = 8;
    bool operator==(const Recipe&) const = default;

    /// In metres at a place of the map: `reach` is in radii of the tube, or halves of the cube's side.
    double reach_at(const glm::dvec2& uv) const { return double(reach) * model.unit(uv); }
};

/// The fine model: its mesh, and what the walk through its tree reads.
struct HighModel {
    HighModel(const Model& model, int fineness, bool cord);
    Mesh mesh;
    TriangleTree tree;
    Texture nodes, corners, normals;
    GpuMesh uploaded;
};

struct Baked {
    Recipe recipe;
    std::array<GLuint, 3> programs;  ///< that made it
    TexelTarget texels, map;         ///< texels: normals before padding, and hits; map: as it is stored, with levels

    /// Shares of the covered texels, and how many are covered twice.
    struct Report {
        double missed = 0, wrong = 0;
        int covered_twice = 0;
        int unwritten = 0;  ///< without task 7.1 or 7.2 nothing is known of rays: 1 or 2, else 0
    };
};

class Baker {
public:
    /// The high model of a recipe; made when it changes.
    const HighModel& high(const Recipe& recipe);
    /// The low one, cut along the diagonals that it was baked with, or the other ones.
    const GpuMesh& low(const Recipe& recipe, bool other_diagonal);
    /// The map of a recipe: baked when the recipe or a shader has changed. There is one for the ammonite and one for
    /// the cube. Leaves another framebuffer and viewport.
    const Baked& bake(const Recipe& recipe);
    /// Reads a bake back, once.
    Baked::Report report(const Baked& baked);
    /// Draws the cover of the map into the bound viewport, added up.
    void draw_cover(const Recipe& recipe);

private:
    Programs bake_{"07_baking/bake.vert", "07_baking/bake.frag"};
    Programs pad_{"07_baking/window.vert", "07_baking/pad.frag"};
    Programs store_{"07_baking/window.vert", "07_baking/store.frag"};
    Programs clear_{"07_baking/window.vert", "07_baking/cover.frag"};
    Programs cover_{"07_baking/bake.vert", "07_baking/cover.frag"};
    // 0 the ammonite's, 1 the cube's.
    struct OfShape {
        Kept<std::unique_ptr<HighModel>, Model, int, bool> high;  ///< its fineness, and whether it has the cord
        /// By fineness, and whether islands overlap; cut along the same diagonals, and along the others.
        std::array<Kept<std::unique_ptr<GpuMesh>, Model, int, bool>, 2> low;
        std::unique_ptr<Baked> baked;
        std::optional<Baked::Report> report;
    };
    OfShape of_shape_[2];
    std::optional<VertexArrayName> nothing_;

    OfShape& of_shape(const Recipe& recipe) { return of_shape_[recipe.model.shape == Shape::cube ? 1 : 0]; }
    void draw_window();
};

}  // namespace relief::baking
