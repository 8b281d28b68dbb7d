// A framebuffer of textures that the next pass reads: several floats a texel.
#pragma once

#include <glm/glm.hpp>
#include <initializer_list>
#include <optional>
#include <vector>

#include "framework/core/gl/object.h"
#include "framework/core/image/image.h"

namespace relief {

class TexelTarget {
public:
    /// Allocates one texture for each of `formats` (GL_RGBA32F, GL_RGBA16, GL_RGBA8): colour attachments 0, 1, ... in
    /// this order. With `mips` they have all levels and trilinear filtering, else nearest filtering. Coordinates are
    /// clamped to the edge. With `depth` it has a depth buffer. Throws Error when the driver cannot hold it.
    TexelTarget(glm::ivec2 size, std::initializer_list<GLenum> formats, bool mips = false, bool depth = false);
    ~TexelTarget();
    TexelTarget(const TexelTarget&) = delete;
    TexelTarget& operator=(const TexelTarget&) = delete;

    glm::ivec2 size() const { return size_; }
    /// Binds an attachment to a texture unit as GL_TEXTURE_2D.
    void bind(int unit, size_t attachment = 0) const;
    /// Binds the framebuffer and sets the viewport to all of level 0. Draws go to all attachments.
    void begin() const;
    /// Fills levels 1 and up with averages of the level before. Changes the texture bound to the active unit.
    void make_mips() const;
    /// Reads level 0 as four-channel floats, row 0 at the top.
    Image read(size_t attachment = 0) const;

private:
    glm::ivec2 size_;
    FramebufferName framebuffer_;
    std::vector<TextureName> textures_;
    std::optional<RenderbufferName> depth_;
    int64_t bytes_ = 0;
};

}  // namespace relief
