// The values at one pixel, beside the mouse. In the window module only.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "framework/lab/manifest.h"

namespace relief {

class ErrorMap;
class Stage;

/// A row's name and its numbers: "value", "1.5  2".
struct PixelRow {
    const char* name;
    std::string numbers;
};
/// What one pixel of a probe has: its value, and with `exact`, of the same shape, what it should be and the error in
/// the probe's unit.
std::vector<PixelRow> pixel_rows(const ProbeInfo& probe, glm::ivec2 pixel, const Image& values, const Image* exact);
/// The rows below each other, their names quiet.
void draw_rows(const std::vector<PixelRow>& rows);

/// Shows, for the pixel under the mouse, what a shown probe or the error map has there: the value, the exact value and
/// how far the two are apart. A click holds the pixel, another one lets it go.
class PixelValues {
public:
    /// The picture has its corner at `at`; the error map, if it is on, stands right of it.
    void draw(const Stage& stage, const ErrorMap& map, glm::ivec2 at, glm::ivec2 size);

private:
    std::optional<glm::ivec2> held_;
};

}  // namespace relief
