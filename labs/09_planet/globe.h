// What the graphics card has of lab 09's planet: for each patch that is drawn its vertices, and its map of normals,
// which the card makes itself.
#pragma once

#include <map>
#include <memory>
#include <utility>

#include "framework/gl/texel_target.h"
#include "patches.h"

namespace relief::planet {

/// How heights become normals: by the metric (tasks 9.2 and 9.3), or by what is commonly written.
enum class Normals : int { metric, right_angled, b_by_cross, one_scale };

/// All that a map depends on.
struct MapRecipe {
    Shape shape;
    Normals normals = Normals::metric;
    int texels = 64;  ///< along a patch's side, without the gutter
    bool gutter = true;
    int strength = 0;     ///< of the slopes at level l: 2^l, 1 + 2^l, 1
    bool slopes = false;  ///< in place of normals: what the probe `slope` shows
    bool operator==(const MapRecipe&) const = default;
};

/// The definitions of shaders/09_planet/grid.glsl.
Define mapping_define(Mapping mapping);

class Globe {
public:
    /// Vertices and, with `maps`, maps of these patches, and of no others. Leaves another framebuffer and viewport when
    /// it has made maps.
    void prepare(const MapRecipe& recipe, const std::vector<Leaf>& patches, bool maps);
    /// Draws patch `i` of those; the program is in use. Sets what is its own: u_middle, u_minus, u_centre,
    /// u_map_corner.
    void draw(const Program& program, const Plan& plan, size_t i, bool precise) const;
    void bind_maps(int unit) const {
        if (map_) map_->bind(unit);
    }
    /// Lower left texel of a patch's tile in the map.
    glm::ivec2 map_corner(size_t i) const;
    int triangles_of_patch() const { return index_count_ / 3; }
    int skirt_triangles() const { return 8 * quads_; }

private:
    struct Vertex {
        glm::vec3 from_middle;  ///< radii
        float is_skirt;
        glm::vec2 local;
    };
    struct Slot {
        int place = 0;
        glm::dvec3 middle;  ///< of the patch, radii
        bool has_vertices = false, has_map = false;
    };
    struct Buffers {
        VertexArrayName layout;
        BufferName vertices, indices;
    };
    void make_buffers(int quads);
    void make_vertices(const Shape& shape, const std::vector<PatchId>& fresh);
    /// Those that fill the maps: heights, then normals.
    std::pair<const Program&, const Program&> programs_of(const MapRecipe& recipe) const;
    void make_maps(const MapRecipe& recipe, const std::vector<PatchId>& fresh);
    void set_patch(const Program& program, const MapRecipe& recipe, const PatchId& id) const;
    int tile_columns() const { return 16; }

    Programs heights_{"09_planet/window.vert", "09_planet/heights.frag"};
    Programs normals_{"09_planet/window.vert", "09_planet/normals.frag"};
    std::optional<Buffers> buffers_;
    std::optional<VertexArrayName> nothing_;
    std::unique_ptr<TexelTarget> map_;
    std::map<PatchId, Slot> slots_;
    std::vector<PatchId> drawn_;
    MapRecipe recipe_;
    std::array<GLuint, 2> programs_{};
    int capacity_ = 0, quads_ = 0, index_count_ = 0;
};

/// The uniforms of shaders/09_planet/heights.glsl.
void set_ground(const Program& program, const Ground& ground);

}  // namespace relief::planet
