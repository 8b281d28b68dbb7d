// The course's own textures, by file name.
#pragma once

#include <string>
#include <vector>

#include "framework/core/image/image.h"

namespace relief {

struct NamedTexture {
    std::string file;  ///< "bricks_albedo.png"
    ColorSpace space = ColorSpace::linear;
    Image image;
};

/// Returns the textures of a surface. "bricks" and "paving": albedo, height, normal map, and gloss, height and
/// occlusion in one. "marble": albedo. "quilt": normals in three spaces. "garden": the grass, the ivy, lab 08's masks,
/// and its bricks' highlights. "rope": the normal map of the ring of rope.
std::vector<NamedTexture> make_textures(const std::string& surface);

}  // namespace relief
