// The values at one pixel, beside the mouse. In the window module only.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "framework/course/manifest/manifest.h"
#include "framework/course/window/menu_layout.h"

namespace relief::window {

class ErrorMap;
class Stage;

/// A row's name and its numbers, such as "value" and "1.5  2".
struct PixelRow {
    const char* name;
    std::string numbers;
};
/// Returns the rows for one pixel of a probe: its value and, with `exact`, the exact value and the error in the probe's
/// unit. `exact` must have the shape of `values`.
std::vector<PixelRow> pixel_rows(const ProbeInfo& probe, glm::ivec2 pixel, const Image& values, const Image* exact);
/// Draws the rows below each other, their names in the quiet colour.
void draw_rows(const std::vector<PixelRow>& rows);

/// Shows the values at the pixel under the mouse, for a probe or the error map: the value, the exact value and their
/// difference. A click holds the pixel, another click releases it.
class PixelValues {
public:
    /// `at` is the upper left corner of the picture. The error map, if it is on, stands to the right of the picture.
    /// The values hide none of the `words`.
    void draw(const Stage& stage, const ErrorMap& map, glm::ivec2 at, glm::ivec2 size, const std::vector<Box>& words);

private:
    std::optional<glm::ivec2> held_;
};

}  // namespace relief::window
