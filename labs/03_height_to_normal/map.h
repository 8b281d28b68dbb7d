// A texture of floats that a fragment shader fills, one fragment a texel.
#pragma once

#include "framework/core/image/compare.h"
#include "framework/core/image/image.h"
#include "framework/library/kit/window_triangle.h"

namespace relief::heights {

class Map {
public:
    /// `format` is GL_R32F or GL_RGBA32F. Binds texture unit 0 and the framebuffer.
    Map(int side, GLenum format);

    /// Fills the map by the program in use, with a triangle over the whole map.
    void fill(WindowTriangle& window) const;
    /// Fills the map with an image of the same size, row 0 at the top. Channels that the image lacks are 1.
    void fill(const Image& image) const;
    Image read(int channels) const;
    /// Returns whether the task that fills a map of normals is written: no texel is marked as unfinished.
    bool is_written() const;
    void bind(int unit) const;

    ErrorSummary error = {};  ///< of the map's values; its count is 0 if no exact values are known

private:
    int side_;
    GLenum format_;
    TextureName texture_;
    FramebufferName framebuffer_;
};

}  // namespace relief::heights
