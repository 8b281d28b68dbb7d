// The maps that the searches of lab 12 read. A map is made and uploaded when it is first needed.
#pragma once

#include <algorithm>
#include <chrono>

#include "framework/core/gl/counters.h"
#include "framework/core/lab/lab.h"
#include "framework/library/kit/choices.h"
#include "framework/library/kit/relief_surface.h"
#include "framework/library/maps/bounds.h"
#include "framework/library/maps/skips.h"
#include "relaxed_cones.h"

namespace relief::exact {

enum Method : int { walk, coarse, windows, max_mip, cones, relaxed };
inline constexpr auto methods = choices<Method>({{walk, "walk"},
                                                 {coarse, "coarse", "COARSE"},
                                                 {windows, "windows", "WINDOWS"},
                                                 {max_mip, "max-mips", "MAX_MIPS"},
                                                 {cones, "cones", "CONES"},
                                                 {relaxed, "relaxed", "RELAXED"}});
constexpr int exact_methods = 5;  ///< the first five return the same hit

class Skips {
public:
    /// Precondition: `surface` outlives this object, and its heights do not change.
    explicit Skips(const ReliefSurface& surface)
        : surface_(surface),
          highest_(*std::max_element(surface.heights().values.begin(), surface.heights().values.end())) {}
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

    const ReliefSurface& surface_;
    float highest_;
    std::array<Costs, methods.size()> costs_{};
    std::array<bool, methods.size()> made_{};
    Texture around_{"highest in 5 x 5", [this] { return highest_in_5x5(surface_.heights()); }, {.mips = false}};
    Texture bounds_{"bounds", [this] { return min_max_atlas(surface_.heights()); }, {.mips = false}};
    Texture cones_{"cones", [this] { return cone_map(surface_.heights()); }, {.mips = false}};
    Texture relaxed_{"relaxed cones", [this] { return relaxed_cone_map(surface_.heights()); }, {.mips = false}};
};

}  // namespace relief::exact
