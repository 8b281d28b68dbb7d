// A framebuffer of textures: several floats a texel, to be read by the next pass.
#pragma once

#include <glm/glm.hpp>
#include <initializer_list>
#include <optional>
#include <vector>

#include "framework/gl/object.h"
#include "framework/image/image.h"

namespace relief {

class TexelTarget {
public:
    /// One texture for each of `formats` (GL_RGBA32F, GL_RGBA16, GL_RGBA8), the colour attachments 0, 1, ... in this
    /// order. With `mips` they have all levels, read trilinearly; else they are read by the nearest texel. Coordinates
    /// are clamped. With `depth` what is near hides what is far. Throws Error when the driver cannot hold it.
    TexelTarget(glm::ivec2 size, std::initializer_list<GLenum> formats, bool mips = false, bool depth = false);
    ~TexelTarget();
    TexelTarget(const TexelTarget&) = delete;
    TexelTarget& operator=(const TexelTarget&) = delete;

    glm::ivec2 size() const { return size_; }
    /// Makes an attachment the 2D texture of a unit.
    void bind(int unit, size_t attachment = 0) const;
    /// Draw into all attachments of level 0, over all of their texels.
    void begin() const;
    /// Levels 1 and on as means of those before. Leaves another texture bound on the active unit.
    void make_mips() const;
    /// Level 0 as floats of four channels, row 0 at the top.
    Image read(size_t attachment = 0) const;

private:
    glm::ivec2 size_;
    FramebufferName framebuffer_;
    std::vector<TextureName> textures_;
    std::optional<RenderbufferName> depth_;
    int64_t bytes_ = 0;
};

}  // namespace relief
