// Textures that are loaded when a draw first binds them.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "framework/gl/object.h"
#include "framework/image/image.h"

namespace relief {

enum class Wrap { repeat, clamp };

struct TextureOptions {
    ColorSpace space = ColorSpace::linear;
    Wrap wrap = Wrap::repeat;
    /// Trilinear over the chain of mip_chain(), else bilinear on level 0 alone.
    bool mips = true;
    /// Samples along the longer side of a pixel's footprint, where the driver can; 1 is none. Unless it is said, a GPU
    /// takes 8 and a software renderer 1: there 4 samples make the whole frame of lab 01 four times as long.
    std::optional<float> anisotropy = {};
};

/// A 2-D texture, named at first use. Row 0 of the image is the top, and v grows up. 8-bit images become
/// GL_R8 to GL_RGBA8 or GL_SRGB8(_ALPHA8), 16-bit ones GL_R16 to GL_RGBA16, floats GL_R32F to GL_RGBA32F.
class Texture {
public:
    Texture(std::string title, std::function<Image()> make, TextureOptions options = {});
    /// With mip levels of one's own, from level 0 down to 1 x 1.
    Texture(std::string title, std::function<std::vector<Image>()> make, TextureOptions options = {})
        : title_(std::move(title)), make_(std::move(make)), options_(options) {}
    ~Texture();
    Texture(Texture&& other) noexcept
        : title_(std::move(other.title_)),
          make_(std::move(other.make_)),
          options_(other.options_),
          name_(std::move(other.name_)),
          bytes_(std::exchange(other.bytes_, 0)) {}
    Texture& operator=(Texture&&) = delete;

    /// Throws Error when the image cannot be made or is too large for the driver.
    operator GLuint() const;

private:
    void create() const;

    std::string title_;
    std::function<std::vector<Image>()> make_;  ///< the levels
    TextureOptions options_;
    mutable std::optional<TextureName> name_;
    mutable int64_t bytes_ = 0;
};

/// A file below the course's `assets` folder.
Texture load_texture(const char* asset, TextureOptions options);
Texture load_texture(const char* asset, ColorSpace space);

/// Makes the texture current on a unit.
void bind(int unit, const Texture& texture);

}  // namespace relief
