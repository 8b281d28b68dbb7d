#include "framework/core/kit/shadow_map.h"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "framework/core/mesh/parallelogram.h"

namespace relief {
namespace {

/// Returns the orthographic view from the light, whose clip space holds the whole box.
glm::dmat4 light_view(const glm::dvec3& to_light, const glm::dvec3& low, const glm::dvec3& high) {
    const PlaneAxes axes = plane_axes(to_light);
    const glm::dmat3 light_from_model = glm::transpose(glm::dmat3(axes.right, axes.up, to_light));
    glm::dvec3 least(INFINITY), most(-INFINITY);
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 corner(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z);
        least = glm::min(least, light_from_model * corner), most = glm::max(most, light_from_model * corner);
    }
    const glm::dvec3 margin = 0.01 * (most - least) + 1e-6;
    least -= margin, most += margin;
    return glm::ortho(least.x, most.x, least.y, most.y, -most.z, -least.z) * glm::dmat4(light_from_model);
}

}  // namespace

void ShadowMap::draw(const glm::dvec3& to_light, const glm::dvec3& low, const glm::dvec3& high,
                     const std::function<void(const glm::dmat4& clip_from_model)>& draw) {
    if (!map_) map_.emplace(glm::ivec2(side), DepthTarget::Lookup::linear);
    map_->begin();
    glClear(GL_DEPTH_BUFFER_BIT);
    // A lookup compares with four texels, each up to one texel away along x and along y. There, the depth of a plane
    // differs by at most twice its larger slope.
    glPolygonOffset(2, 8);
    glEnable(GL_POLYGON_OFFSET_FILL);
    const glm::dmat4 clip_from_model = light_view(to_light, low, high);
    draw(clip_from_model);
    glDisable(GL_POLYGON_OFFSET_FILL);
    map_from_model_ = glm::scale(glm::translate(glm::dmat4(1), glm::dvec3(0.5)), glm::dvec3(0.5)) * clip_from_model;
}

void ShadowMap::set(const Program& program, int unit) const {
    program.set("u_map_from_model", map_from_model_);
    program.set("s_shadow", unit);
    map_->bind(unit);
}

}  // namespace relief
