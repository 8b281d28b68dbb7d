// The picture of a mask's mip levels: how each rule for alpha draws them, and what they cover.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "framework/library/kit/kept.h"
#include "framework/library/kit/labels.h"
#include "framework/library/kit/window_triangle.h"
#include "settings.h"

namespace relief::materials {

class MaskLevels {
public:
    static constexpr const char* mask = "wire_mask.png";

    /// Draws levels 0 to 5 side by side. A picture has a row for each rule in Settings::alphas, with captions in
    /// `labels`. A probe has one row, by `alpha`.
    void draw(const Frame& frame, Labels& labels, int alpha, float threshold);

    /// Returns the exact values of the probe `coverage`.
    static std::optional<Image> truth(glm::ivec2 size, const Probe& probe);

private:
    static constexpr int levels_shown = 6;

    void draw_level(int level, int alpha, float threshold, const Define& purpose);
    double measure(int level, int alpha, float threshold);

    Programs program_{"common/window.vert", "08_obj_materials/levels.frag"};
    WindowTriangle window_;
    std::optional<Texture> texture_;
    std::vector<float> scales_;
    std::array<Kept<double, float, int>, Settings::alphas.size() * levels_shown> coverages_;
};

}  // namespace relief::materials
