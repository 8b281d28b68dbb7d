// A float framebuffer with depth that the next pass reads: linear light, blended before it is encoded.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "framework/core/gl/object.h"

namespace relief {

class LightTarget {
public:
    /// Allocates `attachments` textures of RGBA32F. `samples` is clamped to the driver's maximum: see samples(). With
    /// more than one sample the textures are multisampled. Throws Error when the driver cannot hold it.
    LightTarget(glm::ivec2 size, int samples, int attachments = 1);
    ~LightTarget();
    LightTarget(const LightTarget&) = delete;
    LightTarget& operator=(const LightTarget&) = delete;

    glm::ivec2 size() const { return size_; }
    int samples() const { return samples_; }
    /// Binds the framebuffer and enables `count` attachments, starting with `first`; all share one depth buffer.
    /// Location 0 of a fragment shader writes `first`. Does not change the viewport.
    void begin(int first = 0, int count = 1) const;
    /// Binds an attachment to a texture unit: as GL_TEXTURE_2D with nearest filtering, or as GL_TEXTURE_2D_MULTISAMPLE.
    void bind(int unit, int attachment = 0) const;

private:
    GLenum target() const { return samples_ > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D; }

    glm::ivec2 size_;
    int samples_;
    FramebufferName framebuffer_;
    RenderbufferName depth_;
    std::vector<TextureName> textures_;
    int64_t bytes_ = 0;
};

}  // namespace relief
