// A layer that a user paints on a height map: what a brush adds to each height.
#pragma once

#include <glm/glm.hpp>

#include "framework/core/image/image.h"

namespace relief {

/// One touch of a brush.
struct Dab {
    enum Kind { raise, lower, smooth };
    Kind kind = raise;
    glm::dvec2 place{};   ///< u and v of its middle, in [0, 1); v grows upwards
    double radius = 0.1;  ///< in widths of the map
    /// Change of the height in the middle; for `smooth`, the share of the mean of the neighbours, at most 1. It falls
    /// to 0 at the radius.
    double strength = 0.1;
};

class PaintLayer {
public:
    static constexpr int side = 256;  ///< texels

    /// Adds a dab. `heights` are those with the layer, of any square size. With `wraps` the brush goes on at the map's
    /// other side.
    void add(const Dab& dab, const Image& heights, bool wraps);
    /// Returns heights with the layer, between 0 and 1. Without paint it returns `heights` as they are.
    Image on(const Image& heights) const;

    bool is_empty() const { return values_.values.empty(); }
    const Image& values() const { return values_; }
    /// Replaces all paint, for undo. An empty image has none.
    void set(Image values) { values_ = std::move(values), ++version_; }
    /// Increases with each change.
    int version() const { return version_; }

private:
    Image values_;
    int version_ = 0;
};

}  // namespace relief
