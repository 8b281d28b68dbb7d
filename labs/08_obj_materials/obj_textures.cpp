#include "obj_textures.h"

#include <cmath>

#include "coverage.h"
#include "framework/core/image/asset.h"
#include "framework/core/image/mips.h"
#include "framework/library/maps/own_picture.h"

namespace relief {
namespace {

/// Returns a mask in the first channel.
Image mask_of(const std::string& name, bool is_alpha) {
    const Image picture = read_asset(name);
    return is_alpha ? channels_of(picture, 3, 1) : picture;
}

}  // namespace

const Texture* ObjTextures::texture(const std::string& name, ColorSpace space) {
    if (name.empty()) return nullptr;
    const std::string key = (space == ColorSpace::srgb ? "color " : "linear ") + name;
    auto found = textures_.find(key);
    if (found != textures_.end()) return &found->second;
    // A user may change a picture while the lab runs, so another scene does not share it.
    Texture made = name.starts_with("..") ? Texture(key, [name] { return read_asset(name); }, {.space = space})
                                          : load_texture(name.c_str(), space);
    return &textures_.emplace(key, std::move(made)).first->second;
}

const Texture* ObjTextures::mask(const ObjSurface& surface) {
    if (!surface.mask_is_alpha) return texture(surface.mask, ColorSpace::linear);
    const std::string key = "alpha " + surface.mask;
    auto found = textures_.find(key);
    if (found == textures_.end())
        found = textures_.emplace(key, Texture(key, [name = surface.mask] { return mask_of(name, true); })).first;
    return &found->second;
}

const std::vector<float>& ObjTextures::scales(const ObjSurface& surface) {
    std::vector<float>& scales = scales_[{surface.mask, surface.mask_is_alpha}];
    if (scales.empty()) scales = mask_scales(surface.mask, surface.mask_is_alpha);
    return scales;
}

std::vector<float> mask_scales(const std::string& mask, bool is_alpha) {
    std::vector<Image> levels = mip_chain(mask_of(mask, is_alpha), ColorSpace::linear);
    for (Image& level : levels)
        for (float& alpha : level.values) alpha = std::round(alpha * 255) / 255;
    return coverage_scales(levels);
}

}  // namespace relief
