// A depth map: a framebuffer with a depth attachment only, for comparison in the next pass.
#pragma once

#include <glm/glm.hpp>

#include "framework/core/gl/object.h"
#include "framework/core/image/image.h"

namespace relief {

class DepthTarget {
public:
    /// Whether a lookup compares with the nearest texel, or blends the results of the four nearest ones.
    enum class Lookup { nearest, linear };

    /// Allocates 32-bit float depths. Throws Error when the driver cannot hold it.
    explicit DepthTarget(glm::ivec2 size, Lookup lookup = Lookup::nearest);
    ~DepthTarget();
    DepthTarget(const DepthTarget&) = delete;
    DepthTarget& operator=(const DepthTarget&) = delete;

    glm::ivec2 size() const { return size_; }
    /// Binds the map for a sampler2DShadow. A comparison is 1 if the third coordinate is at most the depth of the
    /// texel, else 0. The border depth is 1: outside the map, coordinates up to 1 are unshadowed.
    void bind(int unit) const;
    /// Binds the framebuffer and sets the viewport to the whole map. Does not clear it.
    void begin() const;
    /// Reads the depths: one channel, row 0 at the top.
    Image read() const;

private:
    glm::ivec2 size_;
    FramebufferName framebuffer_;
    TextureName depth_;
    int64_t bytes_ = 0;
};

}  // namespace relief
