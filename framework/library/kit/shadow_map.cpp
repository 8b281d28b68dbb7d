#include "framework/library/kit/shadow_map.h"

#include <glm/gtc/matrix_transform.hpp>

#include "framework/library/kit/light.h"

namespace relief {

void ShadowMap::draw(const glm::dvec3& to_light, const glm::dvec3& low, const glm::dvec3& high,
                     const std::function<void(const glm::dmat4& clip_from_model)>& draw) {
    if (!map_) map_.emplace(glm::ivec2(side), DepthTarget::Lookup::linear);
    map_->begin();
    glClear(GL_DEPTH_BUFFER_BIT);
    // A lookup compares with four texels, each up to one texel away along x and along y. There, the depth of a plane
    // differs by at most twice its larger slope.
    glPolygonOffset(2, 8);
    glEnable(GL_POLYGON_OFFSET_FILL);
    const glm::dmat4 clip_from_model = light_view(to_light, low, high).clip_from_world;
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
