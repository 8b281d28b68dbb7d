// A framebuffer of floats with depth, to be read by the next pass: light that is blended before it is encoded.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "framework/gl/object.h"

namespace relief {

class LightTarget {
public:
    /// `attachments` textures of RGBA32F. With more than one sample they are multisample textures, of no more samples
    /// than the driver has: see samples(). Throws Error when the driver cannot hold it.
    LightTarget(glm::ivec2 size, int samples, int attachments = 1);
    ~LightTarget();
    LightTarget(const LightTarget&) = delete;
    LightTarget& operator=(const LightTarget&) = delete;

    glm::ivec2 size() const { return size_; }
    int samples() const { return samples_; }
    /// Draw into `count` attachments from `first` on, with one depth for all; location 0 of a shader is `first`.
    /// The viewport is left as it is.
    void begin(int first = 0, int count = 1) const;
    /// Makes an attachment the texture of a unit: of GL_TEXTURE_2D, read by the nearest texel, or of
    /// GL_TEXTURE_2D_MULTISAMPLE.
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
