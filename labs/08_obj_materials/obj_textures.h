// The textures of an OBJ model's surfaces, loaded when a draw first binds them.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "framework/core/gl/texture.h"
#include "framework/library/kit/obj_scene.h"

namespace relief {

class ObjTextures {
public:
    /// Returns the texture of a map, by the name that ObjSurface has for it; or a null pointer if `name` is empty.
    const Texture* texture(const std::string& name, ColorSpace space);
    /// Returns the texture of a surface's mask, in its first channel; or a null pointer if it has none.
    const Texture* mask(const ObjSurface& surface);
    /// Returns mask_scales() of a surface's mask. Precondition: it has one.
    const std::vector<float>& scales(const ObjSurface& surface);

private:
    std::map<std::string, Texture> textures_;
    std::map<std::pair<std::string, bool>, std::vector<float>> scales_;
};

/// Returns coverage_scales() of a mask's mip levels as they are in its texture, rounded to 8 bits. With `is_alpha` the
/// mask is the fourth channel of the picture, else the first. Throws as read_asset() does.
std::vector<float> mask_scales(const std::string& mask, bool is_alpha = false);

}  // namespace relief
