// A depth map: a framebuffer with depth alone, to be compared with by the next pass.
#pragma once

#include <glm/glm.hpp>

#include "framework/gl/object.h"
#include "framework/image/image.h"

namespace relief {

class DepthTarget {
public:
    /// Depths of 32-bit floats. Throws Error when the driver cannot hold it.
    explicit DepthTarget(glm::ivec2 size);
    ~DepthTarget();
    DepthTarget(const DepthTarget&) = delete;
    DepthTarget& operator=(const DepthTarget&) = delete;

    glm::ivec2 size() const { return size_; }
    /// For a sampler2DShadow: 1 where the third coordinate is at most the depth of the nearest texel, else 0. Outside
    /// of the map nothing is hidden: 1, up to a coordinate of 1.
    void bind(int unit) const;
    /// Draw into it, over all of its texels. What is there stays: clear it.
    void begin() const;
    /// One channel, row 0 at the top.
    Image read() const;

private:
    glm::ivec2 size_;
    FramebufferName framebuffer_;
    TextureName depth_;
    int64_t bytes_ = 0;
};

}  // namespace relief
