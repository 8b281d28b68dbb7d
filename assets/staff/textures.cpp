#include "assets/staff/textures.h"

#include "assets/bricks.h"
#include "assets/grass.h"
#include "assets/paving.h"
#include "assets/staff/masks.h"
#include "assets/staff/packed.h"
#include "assets/staff/quilt.h"
#include "assets/staff/rope.h"
#include "framework/staff/reference/normals.h"

namespace relief {

std::vector<NamedTexture> make_textures(const std::string& surface) {
    if (surface == "quilt") {
        QuiltMaps maps = make_quilt();
        return {{"quilt_object.png", ColorSpace::linear, std::move(maps.object)},
                {"quilt_world.png", ColorSpace::linear, std::move(maps.world)},
                {"quilt_tangent.png", ColorSpace::linear, std::move(maps.tangent)}};
    }
    if (surface == "garden") {
        GrassMaps grass = make_grass();
        Image normals =
            normals_from_heights(grass.heights, {.texels_u = grass_depth_in_texels, .texels_v = grass_depth_in_texels});
        return {{"grass_albedo.png", ColorSpace::srgb, std::move(grass.albedo)},
                {"grass_normal.png", ColorSpace::linear, std::move(normals)},
                {"ivy_with_alpha.png", ColorSpace::srgb, make_leaves_with_alpha()},
                {"leaves_albedo.png", ColorSpace::srgb, make_leaf_colors()},
                {"leaves_mask.png", ColorSpace::linear, make_leaf_mask()},
                {"wire_mask.png", ColorSpace::linear, make_wire_mask()},
                {"bricks_specular.png", ColorSpace::linear, make_brick_highlights()}};
    }
    if (surface == "rope") return {{"rope_normal.png", ColorSpace::linear, bake_rope()}};
    if (surface == "marble") return {{"marble_albedo.png", ColorSpace::srgb, make_marble()}};
    const bool bricks = surface == "bricks";
    SurfaceMaps maps = bricks ? make_bricks() : make_paving();
    const double depth = bricks ? bricks_depth_in_texels : paving_depth_in_texels;
    Image normals = normals_from_heights(maps.heights, {.texels_u = depth, .texels_v = depth});
    Image packed = make_packed(maps, depth);
    return {{surface + "_albedo.png", ColorSpace::srgb, std::move(maps.albedo)},
            {surface + "_height.png", ColorSpace::linear, std::move(maps.heights)},
            {surface + "_normal.png", ColorSpace::linear, std::move(normals)},
            {surface + "_packed.png", ColorSpace::linear, std::move(packed)}};
}

}  // namespace relief
