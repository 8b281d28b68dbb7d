// Textures that are loaded when a draw first binds them.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "framework/core/gl/object.h"
#include "framework/core/image/texels.h"

namespace relief {

enum class Wrap { repeat, clamp, mirror };

struct TextureOptions {
    ColorSpace space = ColorSpace::linear;
    Wrap wrap = Wrap::repeat;
    std::optional<Wrap> wrap_v = {};  ///< along v, if it differs from `wrap`
    /// Trilinear filtering over the levels of mip_chain(); else bilinear filtering of level 0 only.
    bool mips = true;
    /// More than 1: the picture is cut into this many layers of equal height, for a 2-D array texture. Layer 0 is the
    /// lowest. Sampled with nearest filtering from level 0.
    int layers = 1;
    /// Maximum number of samples along the longer axis of a pixel's footprint, if the driver supports it. 1 disables
    /// anisotropic filtering. Default: 8 on a GPU, but 1 for draws_comparably() and on a software renderer, where 4
    /// samples make the whole frame of lab 01 take four times as long.
    std::optional<float> anisotropy = {};
};

/// A 2-D texture or 2-D array texture, created at first use. Row 0 of the image is the top, and v grows up. 8-bit
/// images become GL_R8 to GL_RGBA8 or GL_SRGB8(_ALPHA8), 16-bit images GL_R16 to GL_RGBA16, float images GL_R32F to
/// GL_RGBA32F.
class Texture {
public:
    Texture(std::string title, std::function<Image()> make, TextureOptions options = {});
    /// `make` returns all mip levels, from level 0 down to 1 x 1.
    Texture(std::string title, std::function<std::vector<Image>()> make, TextureOptions options = {});
    Texture(Texture&&) noexcept = default;
    Texture& operator=(Texture&&) = delete;

    /// Throws Error when the image cannot be made or is too large for the driver.
    operator GLuint() const;
    GLenum target() const { return options_.layers > 1 ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D; }

private:
    /// The texture object in the driver.
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

/// Loads a file below the course's `assets` folder. All textures of the same file and options share one GL texture,
/// which lives until the last of them is destroyed.
Texture load_texture(const char* asset, TextureOptions options);
Texture load_texture(const char* asset, ColorSpace space);

/// Binds the texture to a texture unit.
void bind(int unit, const Texture& texture);

}  // namespace relief
