// Bakes on the graphics card: draws the coarse model into its map, and finds the fine one by a ray from each texel.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "framework/core/gl/texel_target.h"
#include "framework/library/kit/choices.h"
#include "framework/library/kit/kept.h"
#include "framework/library/kit/window_triangle.h"
#include "models.h"
#include "ray_mesh.h"

namespace relief::baking {

#include "shaders/07_baking/takes.glsl"

/// The frame that is made of the interpolated normal and tangent.
enum NormalFrame { interpolated, each_unit, gram_schmidt, vertex_bitangent };
inline constexpr auto frames = choices<NormalFrame>({{interpolated, "interpolated"},
                                                     {each_unit, "each-unit", "EACH_UNIT"},
                                                     {gram_schmidt, "gram-schmidt", "GRAM_SCHMIDT"},
                                                     {vertex_bitangent, "vertex-bitangent", "VERTEX_BITANGENT"}});
constexpr size_t bake_frames = 3;  ///< a bake can store in the first three

enum class Take { nearest = take_nearest, first = take_first, last = take_last };
inline constexpr auto takes = choices<Take>({{Take::nearest, "nearest"}, {Take::first, "first"}, {Take::last, "last"}});

/// A format of the map, named by the bits of a channel.
struct MapFormat {
    const char* name;
    GLenum format;
};
inline constexpr std::array<MapFormat, 3> formats = {{{"8", GL_RGBA8}, {"16", GL_RGBA16}, {"float", GL_RGBA32F}}};

/// Everything that a bake depends on. `high`, `low` and `bits` are indices into a knob's choices.
struct Recipe {
    Model model;
    int high = 0, low = 1;
    bool cord = false, overlapping = false, object_space = false, rays_of_face = false;
    int frame = interpolated, take = take_nearest;
    float reach = 0.42f;
    int size = 256, bits = 0, padding = 8;
    Sculpt sculpt = {};
    const OwnModels* own = nullptr;  ///< of Shape::own
    bool has_fine = false;           ///< of `own`
    int version = 0;                 ///< of `own`
    bool operator==(const Recipe&) const = default;

    /// Returns the reach in metres at a place of the map. `reach` itself is in Model::unit().
    double reach_at(const glm::dvec2& uv) const { return double(reach) * model.unit(uv); }
    /// Returns whether the model is the ammonite, which has turns and grows.
    bool is_ammonite() const { return model.shape == Shape::ammonite || model.shape == Shape::mirrored; }
    Mesh high_mesh() const;
    /// See make_low(). An own model has the diagonals of its file.
    Mesh low_mesh(bool other_diagonal) const;
};

struct Baked {
    Recipe recipe;
    std::array<GLuint, 3> programs;  ///< the programs that made it
    TexelTarget texels, map;  ///< `texels`: normals before padding, and hits; `map`: the stored map, with mip levels

    /// The results of the rays, as shares of the covered texels, and the number of texels that are covered twice.
    struct Report {
        double missed = 0, wrong = 0;  ///< met nothing; met another part of the model
        int covered_twice = 0;
        int unwritten = 0;  ///< 1 or 2 if task 7.1 or 7.2 is unfinished, so that the rays are unknown; else 0
    };
};

class Baker {
public:
    /// Returns the high model of a recipe, made again if it has changed.
    const RayMesh& high(const Recipe& recipe);
    /// Returns the low model of a recipe. Its quads are cut along the diagonals of the bake, or along the other ones.
    const GpuMesh& low(const Recipe& recipe, bool other_diagonal);
    /// Returns the map of a recipe, baked again if the recipe or a shader has changed. Keeps one map for the ammonite,
    /// one for the cube and one for files, so the reference is valid until the next bake of that shape. May change the
    /// framebuffer and the viewport.
    const Baked& bake(const Recipe& recipe);
    /// Returns the report of the shape's latest bake. Reads its textures back at the first call.
    Baked::Report report(const Baked& baked);
    /// Draws the number of triangles that cover each texel into the bound framebuffer.
    void draw_cover(const Recipe& recipe);

private:
    Programs bake_{"07_baking/bake.vert", "07_baking/bake.frag"};
    Programs pad_{"common/window.vert", "07_baking/pad.frag"};
    Programs store_{"common/window.vert", "07_baking/store.frag"};
    Programs clear_{"common/window.vert", "07_baking/cover.frag"};
    Programs cover_{"07_baking/bake.vert", "07_baking/cover.frag"};
    // Index 0 of of_shape_ is the ammonite, 1 the cube, 2 a file.
    struct OfShape {
        Kept<std::unique_ptr<RayMesh>, Model, int, bool, Sculpt, int> high;  ///< by fineness, cord and version
        /// Recomputed when fineness, overlap of islands or version changes. Index 1 has the opposite diagonals.
        std::array<Kept<std::unique_ptr<GpuMesh>, Model, int, bool, int>, 2> low;
        std::unique_ptr<Baked> baked;
        std::optional<Baked::Report> report;
    };
    OfShape of_shape_[3];
    WindowTriangle window_;

    OfShape& of_shape(const Recipe& recipe) {
        return of_shape_[recipe.is_ammonite() ? 0 : recipe.model.shape == Shape::cube ? 1 : 2];
    }
    void cast_rays(const Program& program, const Recipe& recipe, const TexelTarget& texels);
    void grow_islands(const Program& program, const Recipe& recipe, const TexelTarget& from, const TexelTarget& to);
    void round_texels(const Program& program, const TexelTarget& texels, const TexelTarget& map);
};

}  // namespace relief::baking
