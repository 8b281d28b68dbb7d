// The shadow of a distant light on a model: a depth map of the model as the light sees it (Williams 1978).
#pragma once

#include <functional>
#include <optional>

#include "framework/core/gl/depth_target.h"
#include "framework/core/gl/program.h"

namespace relief {

class ShadowMap {
public:
    /// Draws the depth map of a model within the box from `low` to `high`, in the model's coordinates, as is the unit
    /// vector to the light. `draw(clip_from_model)` draws the model by a program that writes depth. Leaves the map's
    /// framebuffer bound, with its viewport.
    void draw(const glm::dvec3& to_light, const glm::dvec3& low, const glm::dvec3& high,
              const std::function<void(const glm::dmat4& clip_from_model)>& draw);
    /// Sets u_map_from_model, which yields the place in the map and the depth there, and binds s_shadow to `unit`.
    /// Preconditions: draw(), and the program is in use.
    void set(const Program& program, int unit) const;

private:
    static constexpr int side = 2048;  ///< texels
    std::optional<DepthTarget> map_;
    glm::dmat4 map_from_model_{};
};

}  // namespace relief
