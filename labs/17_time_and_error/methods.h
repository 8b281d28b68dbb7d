// The methods of lab 17 in one table: their names, their definitions in the shaders, and the colours that stand for
// them.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "framework/library/kit/choices.h"
#include "framework/library/kit/labels.h"
#include "wall.h"

namespace relief::budget {

/// The values of the knob: `automatic`, then 1 + each Method. The definition compiles a method in.
inline constexpr int automatic = 0, first_method = 1;
inline constexpr auto methods = choices<int>({{automatic, "auto"},
                                              {first_method + plain, "plain"},
                                              {first_method + normal_map, "normal-map", "NORMAL_MAP"},
                                              {first_method + parallax, "parallax", "PARALLAX"},
                                              {first_method + exact, "exact", "EXACT"},
                                              {first_method + displacement, "displacement", "DISPLACEMENT"}});
/// Linear light.
inline constexpr std::array<glm::vec3, method_count> colors = {{{0.10f, 0.12f, 0.22f},
                                                                {0.05f, 0.25f, 0.42f},
                                                                {0.14f, 0.45f, 0.20f},
                                                                {0.85f, 0.50f, 0.08f},
                                                                {0.65f, 0.08f, 0.06f}}};

/// Share of the picture that each method draws, in [0, 1]. Nothing before the tasks are written.
using Shares = std::optional<std::array<double, method_count>>;

/// Returns the shares in an image of the probe `method`.
inline Shares shares_in(const Image& drawn) {
    if (std::find(drawn.values.begin(), drawn.values.end(), not_written) != drawn.values.end()) return {};
    std::array<double, method_count> shares{};
    double count = 0;
    for (size_t i = 0; i < drawn.values.size(); i += 4)
        if (std::isfinite(drawn.values[i])) ++shares[size_t(drawn.values[i])], ++count;
    for (double& share : shares) share /= std::max(1.0, count);
    return shares;
}

/// Adds the methods, with their colours and shares, to the legend of a tile.
inline void add_legend(Labels& labels, glm::ivec2 size, const Tile& tile, const Shares& shares) {
    for (size_t i = 0; i < method_count; ++i) {
        const std::string share = shares ? fmt::format(" {:.0f} %", 100 * (*shares)[i]) : "";
        labels.legend(size, tile, methods.names[first_method + i] + share, glm::pow(colors[i], glm::vec3(1 / 2.2f)));
    }
}

}  // namespace relief::budget
