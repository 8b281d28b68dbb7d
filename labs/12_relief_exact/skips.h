// The maps that each search of lab 12 uses: computed when first needed, on the GPU from then
// on.
#pragma once

#include <algorithm>
#include <chrono>
#include <optional>

#include "framework/gl/counters.h"
#include "framework/height/bounds.h"
#include "framework/height/skips.h"
#include "framework/lab/lab.h"

namespace relief::exact {

enum Method : int { walk, coarse, windows, cells, max_mip, cones };
inline constexpr std::array method_names = {"walk", "coarse", "windows", "cells", "max-mips", "cones"};
inline constexpr std::array method_defines = {"WALK", "COARSE", "WINDOWS", "CELLS", "MAX_MIPS", "CONES"};

class Skips {
public:
    explicit Skips(const Image& heights)
        : heights_(heights),
          highest_(heights.values.empty() ? 0 : *std::max_element(heights.values.begin(), heights.values.end())) {}
    Skips(const Skips&) = delete;

    /// A cell map is 64 bytes a cell: on a larger map than 1024 x 1024, windows take its place.
    Method usable(Method method) const { return method == cells && heights_.width > 1024 ? windows : method; }
    /// Uniforms and textures (from unit 3 on) for shaders/12_relief_exact/search.glsl; the program is in use.
    void set(const Program& program, Method method);

    struct Costs {
        double megabytes = 0, milliseconds = 0;  ///< memory of the textures; time to make and to upload them
    };
    /// Of what set() has made for the method.
    Costs costs(Method method) const { return costs_[size_t(method)]; }

private:
    void make(Method method);

    const Image& heights_;
    float highest_;
    std::array<Costs, 6> costs_{};
    std::array<bool, 6> made_{};
    HeightWindows windows_;
    std::array<int, 4> cells_grown_{};
    std::optional<TextureName> cells_;
    Texture window_texture_{"windows", [this] { return windows_.clear; }, {.mips = false}};
    Texture around_{"highest in 5 x 5", [this] { return highest_in_5x5(heights_); }, {.mips = false}};
    Texture bounds_{"bounds", [this] { return min_max_atlas(heights_); }, {.mips = false}};
    Texture cones_{"cones", [this] { return cone_map(heights_); }, {.mips = false}};
};

}  // namespace relief::exact
