// The course's own textures, by the names of their files.
#pragma once

#include <string>
#include <vector>

#include "framework/image/image.h"

namespace relief {

struct NamedTexture {
    std::string file;  ///< "bricks_albedo.png"
    ColorSpace space = ColorSpace::linear;
    Image image;
};

/// "bricks" or "paving": albedo, height, normal map, and gloss, height and occlusion in one; "marble": albedo; "quilt":
/// its normals in three spaces; "garden": the grass, the ivy, the masks of lab 08, and how its bricks shine.
std::vector<NamedTexture> make_textures(const std::string& surface);

}  // namespace relief
