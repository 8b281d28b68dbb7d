// Textures that are loaded when a draw first binds them.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "framework/gl/object.h"
#include "framework/image/texels.h"

namespace relief {

enum class Wrap { repeat, clamp };

struct TextureOptions {
    ColorSpace space = ColorSpace::linear;
    Wrap wrap = Wrap::repeat;
    /// Trilinear over the chain of mip_chain(), else bilinear on level 0 alone.
    bool mips = true;
    /// More than 1: a 2-D array of the picture cut into as many of the same height, layer 0 lowest. It is read by the
    /// nearest texel of level 0.
    int layers = 1;
    /// Samples along the longer side of a pixel's footprint, where the driver can; 1 is none. Unless it is said, a GPU
    /// takes 8 and a software renderer 1: there 4 samples make the whole frame of lab 01 four times as long.
    std::optional<float> anisotropy = {};
};

/// A 2-D texture, or an array of them, named at first use. Row 0 of the image is the top, and v grows up. 8-bit images
/// become GL_R8 to GL_RGBA8 or GL_SRGB8(_ALPHA8), 16-bit ones GL_R16 to GL_RGBA16, floats GL_R32F to GL_RGBA32F.
class Texture {
public:
    Texture(std::string title, std::function<Image()> make, TextureOptions options = {});
    /// With mip levels of one's own, from level 0 down to 1 x 1.
    Texture(std::string title, std::function<std::vector<Image>()> make, TextureOptions options = {});
    Texture(Texture&&) noexcept = default;
    Texture& operator=(Texture&&) = delete;

    /// Throws Error when the image cannot be made or is too large for the driver.
    operator GLuint() const;
    GLenum target() const { return options_.layers > 1 ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D; }

private:
    /// What the driver holds.
    struct Loaded {
        TextureName name;
        int64_t bytes = 0;
        ~Loaded();
    };
    Texture() = default;
    std::shared_ptr<const Loaded> create() const;
    friend Texture load_texture(const char* asset, TextureOptions options);

    std::string title_;
    std::function<Texels()> make_;
    TextureOptions options_;
    bool is_asset_ = false;
    mutable std::shared_ptr<const Loaded> loaded_;
};

/// A file below the course's `assets` folder. All that load it with the same options share one texture of the driver's,
/// which is there as long as one of them is.
Texture load_texture(const char* asset, TextureOptions options);
Texture load_texture(const char* asset, ColorSpace space);

/// Makes the texture current on a unit.
void bind(int unit, const Texture& texture);

}  // namespace relief
