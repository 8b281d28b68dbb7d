// The values at one pixel, beside the mouse. In the window module only.
#pragma once

#include <glm/glm.hpp>
#include <optional>

namespace relief {

class ErrorMap;
class Stage;

/// Shows, for the pixel under the mouse, what a shown probe or the error map has there: the value, the exact value and
/// how far the two are apart. A click holds the pixel, another one lets it go.
class PixelValues {
public:
    /// The picture's left edge is at pixel `x`, and the error map, if it is on, right of it.
    void draw(const Stage& stage, const ErrorMap& map, int x, glm::ivec2 size);

private:
    std::optional<glm::ivec2> held_;
};

}  // namespace relief
