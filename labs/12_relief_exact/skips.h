// The maps that the searches of lab 12 read. A map is made and uploaded when it is first needed.
#pragma once

#include <algorithm>
#include <chrono>

#include "framework/gl/counters.h"
#include "framework/height/bounds.h"
#include "framework/height/skips.h"
#include "framework/lab/lab.h"

namespace relief::exact {

enum Method : int { walk, coarse, windows, max_mip, cones };
inline constexpr std::array method_names = {"walk", "coarse", "windows", "max-mips", "cones"};
inline constexpr std::array method_defines = {"WALK", "COARSE", "WINDOWS", "MAX_MIPS", "CONES"};

class Skips {
public:
    explicit Skips(const Image& heights)
        : heights_(heights),
          highest_(heights.values.empty() ? 0 : *std::max_element(heights.values.begin(), heights.values.end())) {}
    Skips(const Skips&) = delete;

    /// Sets the uniforms of shaders/12_relief_exact/search.glsl, and binds a texture to unit 3. Precondition: the
    /// program is in use.
    void set(const Program& program, Method method);

    struct Costs {
        double megabytes = 0, milliseconds = 0;  ///< memory of the textures; time of making and uploading them
    };
    /// Returns the costs of the maps that set() has made for the method; 0 before.
    Costs costs(Method method) const { return costs_[size_t(method)]; }

private:
    void make(Method method);

    const Image& heights_;
    float highest_;
    std::array<Costs, method_names.size()> costs_{};
    std::array<bool, method_names.size()> made_{};
    HeightWindows windows_;
    Texture window_texture_{"windows", [this] { return windows_.clearance; }, {.mips = false, .layers = 4}};
    Texture around_{"highest in 5 x 5", [this] { return highest_in_5x5(heights_); }, {.mips = false}};
    Texture bounds_{"bounds", [this] { return min_max_atlas(heights_); }, {.mips = false}};
    Texture cones_{"cones", [this] { return cone_map(heights_); }, {.mips = false}};
};

}  // namespace relief::exact
