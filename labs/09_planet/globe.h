// Lab 09's planet on the graphics card: the vertices of each patch that is drawn, and its normal map, which a shader
// computes.
#pragma once

#include <memory>
#include <span>

#include "framework/core/gl/texel_target.h"
#include "framework/core/lab/lab.h"
#include "patches.h"
#include "skirted_patch.h"
#include "slots.h"

namespace relief::planet {

/// The grids of SphereMapping, in shaders/09_planet/grid.glsl.
inline constexpr auto mappings = choices<SphereMapping>({{SphereMapping::equal_angle, "equal-angle"},
                                                         {SphereMapping::gnomonic, "gnomonic", "GNOMONIC"},
                                                         {SphereMapping::lat_long, "lat-long", "LAT_LONG"}});

/// The formula for normals from heights: by the metric (tasks 9.2 and 9.3), or by common approximations.
enum class Normals : int { metric, right_angled, b_by_cross, one_scale };
inline constexpr auto normal_rules = choices<Normals>({{Normals::metric, "metric"},
                                                       {Normals::right_angled, "right-angled", "RIGHT_ANGLED"},
                                                       {Normals::b_by_cross, "b-by-cross", "B_BY_CROSS"},
                                                       {Normals::one_scale, "one-scale", "ONE_SCALE"}});
/// The factor on the slopes of a level l: 2^l, (1 + 2^l) / 2, or 1.
enum class Strength : int { doubling, plus_one, none };
inline constexpr auto strengths = choices<Strength>({{Strength::doubling, "2^level"},
                                                     {Strength::plus_one, "1+2^level", "STRENGTH_PLUS_1"},
                                                     {Strength::none, "none", "STRENGTH_NONE"}});

/// Everything that a normal map depends on.
struct MapRecipe {
    Shape shape;
    Normals normals = Normals::metric;
    int texels = 64;  ///< along a patch's side, without the gutter
    bool gutter = true;
    Strength strength = Strength::doubling;
    bool slopes = false;  ///< the map holds slopes in place of normals, for the probe `slope`
    bool operator==(const MapRecipe&) const = default;
};

/// Returns the definition that chooses a mapping in shaders/09_planet/grid.glsl.
inline Define mapping_define(SphereMapping mapping) { return mappings.define(int(mapping)); }

/// Limits of one picture, over all its views: seconds and half a gigabyte with a software renderer. That many texels,
/// in tiles of 16 to 256 texels a side, fit into a texture of 16384 texels a side, the minimum that OpenGL guarantees.
constexpr int most_vertices = 2'200'000, most_texels = 6'000'000;
/// Returns the texels along the side of each patch: `wanted`, halved until all patches have at most `most` texels; at
/// least 16.
constexpr int texels_that_fit(int wanted, size_t patches, int most) {
    while (wanted > 16 && double(patches) * (wanted + 2) * (wanted + 2) > most) wanted /= 2;
    return wanted;
}

class Globe {
public:
    /// Makes the vertices and, with `maps`, the maps of these patches, and drops all others. May change the framebuffer
    /// and the viewport.
    void prepare(const MapRecipe& recipe, const std::vector<Leaf>& patches, bool maps);
    /// Draws patch `i` of the prepared ones, as seen by `eye`. Sets its uniforms: u_middle, u_minus, u_centre,
    /// u_map_corner. Without `precise` floats are subtracted in the shader, which shows their rounding. Precondition:
    /// the program is in use.
    void draw(const Program& program, size_t i, const Plan& plan, const Eye& eye, bool precise) const;
    void bind_maps(int unit) const {
        if (map_) map_->bind(unit);
    }
    /// Returns the normals of all prepared patches, 16 tiles in a row from the upper left, without their gutters; or
    /// nothing if there are no maps. Values are in [0, 1]. Changes the framebuffer.
    std::optional<Image> map_picture() const;
    /// Returns the lower left texel of the tile of patch `i` in the map.
    glm::ivec2 map_corner(size_t i) const;
    int triangles_of_patch(bool skirts) const { return grid_.grid_indices() / 3 + (skirts ? 2 * 4 * grid_.quads : 0); }

private:
    struct Vertex {
        glm::vec3 from_middle;  ///< radii
        float is_skirt;
        glm::vec2 local;
    };
    /// A patch with vertices in the buffer and a tile of the map.
    struct Made {
        glm::dvec3 middle;  ///< of the patch, radii
        bool has_map = false;
    };
    struct Buffers {
        VertexArrayName layout, nothing;
        BufferName vertices, indices;
    };
    void drop_outdated(const MapRecipe& before, bool maps);
    void make_room(int patches);
    std::vector<Vertex> vertices_of(const SpherePatch& patch) const;
    void make_vertices(const std::vector<SpherePatch>& fresh);
    const Program& heights_program() const;
    const Program& normals_program() const;
    /// Makes the maps of the patches without one, in two passes for each batch of patches.
    void make_maps();
    void draw_heights(std::span<const SpherePatch> patches, const TexelTarget& heights);
    void draw_normals(std::span<const SpherePatch> patches, const TexelTarget& heights);
    void set_patch(const Program& program, const SpherePatch& patch) const;

    Programs heights_{"common/window.vert", "09_planet/heights.frag"};
    Programs normals_{"common/window.vert", "09_planet/normals.frag"};
    std::optional<Buffers> buffers_;
    std::unique_ptr<TexelTarget> map_;
    Slots<SpherePatch, Made> slots_;
    std::vector<SpherePatch> drawn_;
    MapRecipe recipe_;
    std::array<GLuint, 2> programs_{};
    SkirtedPatch grid_{0};
};

/// Sets the uniforms of shaders/09_planet/heights.glsl. Precondition: the program is in use.
void set_ground(const Program& program, const Ground& ground);

}  // namespace relief::planet
