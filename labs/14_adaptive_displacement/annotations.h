// The marks over the pictures of lab 14: holes, the eye's field of view, and legends.
#pragma once

#include <optional>
#include <vector>

#include "framework/library/kit/displaced_surface.h"
#include "framework/library/kit/labels.h"
#include "settings.h"

namespace relief::adaptive {

/// Returns the pixels that are holes, counted from the lower left corner. `sums` has the probe `winding`. On a closed
/// surface a hole has a sum that is not 0. On an open one it has the sum 0, and another one close by on all four sides.
std::vector<glm::ivec2> holes_in(const Image& sums, bool is_closed);

/// Marks pixels of a tile by squares. `size` is that of the frame.
void mark(Labels& labels, glm::ivec2 size, const Tile& tile, const std::vector<glm::ivec2>& pixels);

/// Colours of patches that are outside the picture, that face away, and whose relief is faded out.
constexpr glm::vec3 outside_color{0.16f, 0.20f, 0.28f}, away_color{0.34f, 0.27f, 0.25f},
    faded_color{0.62f, 0.70f, 0.72f};

/// The state that captions describe.
struct Described {
    const Settings& settings;
    const DisplacedSurface& surface;
};
/// Writes the share of culled patches, and a legend of the colours. `more` is the number of triangles of culled
/// patches, which are drawn here but not in the eye's picture. It is -1 if unknown.
void describe_patches(Labels& labels, glm::ivec2 size, const Tile& tile, const Described& of, int more);

/// Names the limits that keep the time of a picture in bounds, if any made it coarser. `most_level` is the largest
/// level of the picture.
void describe_limits(Labels& labels, glm::ivec2 size, const Tile& tile, const Described& of, float most_level);

/// The eye and its field of view, as eight lines.
class SightLines {
public:
    /// Draws the field of view of `eye`, as `seen_by` sees it, up to `reach` metres from the eye.
    void draw(const Camera& seen_by, const Camera& eye, double reach);

private:
    Programs program_{"14_adaptive_displacement/sight.vert", "14_adaptive_displacement/sight.frag"};
    std::optional<VertexArrayName> no_corners_;
};

}  // namespace relief::adaptive
