// How far the numbers of one draw are from those of another, as a heat map over a part of a tile.
#pragma once

#include <functional>
#include <optional>

#include "framework/core/gl/texel_target.h"
#include "framework/core/image/compare.h"
#include "framework/library/kit/tiles.h"
#include "framework/library/kit/window_triangle.h"

namespace relief {

class DifferenceMap {
public:
    /// `low` and `high` are the powers of ten at the ends of the colour scale, which is logarithmic.
    DifferenceMap(ErrorMetric metric, int low, int high) : metric_(metric), low_(low), high_(high) {}

    /// Covers the tile from column `left` on, where both draws have a surface. Each draw writes the values of a probe
    /// into the framebuffer that is bound, with the viewport at its lower left corner, as large as the tile. Binds
    /// frame.target again.
    void draw(const Frame& frame, const Tile& tile, int left, const std::function<void()>& measured,
              const std::function<void()>& exact);

private:
    ErrorMetric metric_;
    int low_, high_;
    std::optional<TexelTarget> measured_, exact_;  ///< as large as the largest tile so far
    Programs program_{"common/window.vert", "common/difference.frag"};
    WindowTriangle window_;
};

}  // namespace relief
