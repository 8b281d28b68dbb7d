// Textures of an OBJ model's surfaces.
#include "labs/08_obj_materials/obj_textures.h"

#include <gtest/gtest.h>

#include <vector>

namespace relief {
namespace {

TEST(ObjTextures, AreOneForEachMapAndColorSpace) {
    ObjTextures textures;
    EXPECT_EQ(textures.texture("", ColorSpace::linear), nullptr);
    const Texture* const linear = textures.texture("ivy_with_alpha.png", ColorSpace::linear);
    EXPECT_EQ(textures.texture("ivy_with_alpha.png", ColorSpace::linear), linear);
    EXPECT_NE(textures.texture("ivy_with_alpha.png", ColorSpace::srgb), linear);
    ObjSurface surface;
    EXPECT_EQ(textures.mask(surface), nullptr);
    surface.mask = "ivy_with_alpha.png";
    EXPECT_EQ(textures.mask(surface), linear);
    const std::vector<float> by_first_channel = textures.scales(surface);
    surface.mask_is_alpha = true;
    EXPECT_NE(textures.mask(surface), linear) << "the fourth channel";
    EXPECT_EQ(textures.scales(surface), mask_scales("ivy_with_alpha.png", true));
    EXPECT_NE(textures.scales(surface), by_first_channel);
}

}  // namespace
}  // namespace relief
