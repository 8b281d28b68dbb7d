// Labs that make a map which a user may keep, or whose heights a user may paint. Such a lab derives from these classes
// in addition to Lab.
#pragma once

#include <optional>

#include "framework/core/lab/lab.h"
#include "framework/library/kit/paint_layer.h"

namespace relief {

class MapMaker {
public:
    virtual ~MapMaker() = default;
    /// Returns the map for the present knobs as a file stores it, with values in [0, 1], row 0 at the top; or nothing
    /// if the last draw() made none. Throws Error when a task that it needs is not written. May change the framebuffer,
    /// the viewport and bindings. Precondition: the lab's draw() was called.
    virtual std::optional<Image> made_map() = 0;
};

/// Returns the map of a lab that was drawn, with 16 bits. Throws UsageError that names the labs with a map if this one
/// has none, and Error if these knobs give none.
Image map_of(Lab& lab);

class Paintable {
public:
    virtual ~Paintable() = default;
    /// Returns the place on the map under a pixel of the picture, u and v in [0, 1), or nothing beside the surface.
    /// `pixel` counts from the upper left corner.
    virtual std::optional<glm::dvec2> place_on_map(const Frame& frame, glm::dvec2 pixel) const = 0;
    /// Adds a dab to the layer. Has the preconditions and effects of MapMaker::made_map().
    virtual void paint(const Dab& dab) = 0;
    virtual PaintLayer& paint_layer() = 0;
    /// Returns the heights with the layer, one channel. See MapMaker::made_map().
    virtual Image painted_heights() = 0;
};

}  // namespace relief
