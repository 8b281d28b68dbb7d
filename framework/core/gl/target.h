// The framebuffer of a frame: offscreen, with depth, for pictures or for probes.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>

#include "framework/core/gl/object.h"
#include "framework/core/gl/program.h"
#include "framework/core/image/image.h"

namespace relief {

/// Largest side of a picture, in pixels.
constexpr int max_picture_side = 8192;

enum class TargetKind {
    picture,  ///< RGBA8, sRGB-encoded by the shader, 4 samples a pixel
    light,    ///< the same picture in 32-bit floats, neither clamped nor rounded
    probe     ///< RGBA32F, one sample at the pixel's centre: numbers must not be averaged
};

class Target {
public:
    /// Throws Error when the driver cannot hold it.
    Target(TargetKind kind, glm::ivec2 size);

    TargetKind kind() const { return kind_; }
    glm::ivec2 size() const { return size_; }
    /// Returns the framebuffer that a lab draws into.
    GLuint framebuffer() const { return drawn_; }
    /// Averages the samples into a single-sample framebuffer and returns it. Returns framebuffer() if there is one
    /// sample. Otherwise unbinds the program, disables the depth test and changes the viewport.
    GLuint resolve() const;
    /// Reads the first 1 to 4 channels of all pixels, row 0 at the top. Calls resolve().
    Image read(int channels = 4) const;

private:
    TargetKind kind_;
    glm::ivec2 size_;
    FramebufferName drawn_;
    RenderbufferName depth_;
    std::optional<RenderbufferName> color_;  ///< unless the samples are in a texture
    /// Only with several samples a pixel.
    struct Samples {
        TextureName color;
        FramebufferName framebuffer;  ///< holds the average of the samples
        RenderbufferName means;
        std::shared_ptr<const Program> resolve;
        VertexArrayName nothing;
        explicit Samples(int count);
    };
    std::optional<Samples> samples_;
    /// Only where the driver has samples in renderbuffers, but not in textures (WebGL): a blit takes the average.
    struct Blitted {
        FramebufferName framebuffer;
        RenderbufferName means;
    };
    std::optional<Blitted> blitted_;
};

}  // namespace relief
