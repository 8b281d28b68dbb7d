// A texture of floats that a fragment shader fills, a fragment a texel.
#pragma once

#include "framework/gl/gpu_mesh.h"
#include "framework/image/compare.h"
#include "framework/image/image.h"

namespace relief::heights {

class Map {
public:
    /// `format` is GL_R32F or GL_RGBA32F. Binds texture unit 0 and the framebuffer.
    Map(int side, GLenum format);

    /// By the program in use; one triangle covers the map.
    void fill(const GpuMesh& nothing) const;
    /// By an image of the map's size, row 0 at the top; what it lacks of four channels is 1.
    void fill(const Image& image) const;
    Image read(int channels) const;
    operator GLuint() const { return texture_; }

    ErrorSummary error = {};  ///< of what it holds; no pixels where nothing is known

private:
    int side_;
    GLenum format_;
    TextureName texture_;
    FramebufferName framebuffer_;
};

}  // namespace relief::heights
