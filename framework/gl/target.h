// Where a frame is drawn: an offscreen framebuffer with depth, for pictures or for probes.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "framework/gl/object.h"
#include "framework/gl/program.h"
#include "framework/image/image.h"

namespace relief {

/// Largest side of a picture, in pixels.
constexpr int max_picture_side = 8192;

enum class TargetKind {
    picture,  ///< RGBA8, sRGB-encoded by the shader, 4 samples a pixel
    light,    ///< the same picture in 32-bit floats, so that nothing is clipped or rounded
    probe     ///< RGBA32F, one sample at the centre of the pixel: numbers must not be averaged
};

class Target {
public:
    /// Throws Error when the driver cannot hold it.
    Target(TargetKind kind, glm::ivec2 size);

    TargetKind kind() const { return kind_; }
    glm::ivec2 size() const { return size_; }
    /// What a lab draws into.
    GLuint framebuffer() const { return drawn_; }
    /// Averages the samples (if there are several) into the one-sample framebuffer that is returned. Leaves no program in
    /// use, no depth test and its own viewport.
    GLuint resolve() const;
    /// Reads all pixels, row 0 at the top: the first 1 to 4 channels.
    Image read(int channels = 4) const;

private:
    TargetKind kind_;
    glm::ivec2 size_;
    FramebufferName drawn_;
    RenderbufferName depth_;
    std::optional<RenderbufferName> color_;  ///< of a target with one sample
    /// Of a target with several.
    struct Samples {
        TextureName color;
        FramebufferName framebuffer;  ///< of their means
        RenderbufferName means;
        Program resolve;
        VertexArrayName nothing;
        explicit Samples(int count);
    };
    std::optional<Samples> samples_;
};

}  // namespace relief
