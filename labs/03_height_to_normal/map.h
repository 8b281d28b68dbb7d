// A texture of floats that a fragment shader fills, one fragment a texel.
#pragma once

#include "framework/core/gl/gpu_mesh.h"
#include "framework/core/image/compare.h"
#include "framework/core/image/image.h"

namespace relief::heights {

class Map {
public:
    /// `format` is GL_R32F or GL_RGBA32F. Binds texture unit 0 and the framebuffer.
    Map(int side, GLenum format);

    /// Fills the map by the program in use, with one triangle over the whole map. `nothing` is a mesh without vertices.
    void fill(const GpuMesh& nothing) const;
    /// Fills the map with an image of the same size, row 0 at the top. Channels that the image lacks are 1.
    void fill(const Image& image) const;
    Image read(int channels) const;
    operator GLuint() const { return texture_; }

    ErrorSummary error = {};  ///< of the map's values; its count is 0 if no exact values are known

private:
    int side_;
    GLenum format_;
    TextureName texture_;
    FramebufferName framebuffer_;
};

}  // namespace relief::heights
