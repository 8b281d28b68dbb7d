// The sun's depth map in lab 16: the scene as the sun sees it.
#pragma once

#include <memory>

#include "framework/core/gl/depth_target.h"
#include "framework/library/kit/light.h"
#include "stage.h"

namespace relief::court {

class SunShadow {
public:
    enum Bias { none, constant, plane };
    static constexpr auto biases =
        choices<Bias>({{none, "none"}, {constant, "constant", "BIAS_CONSTANT"}, {plane, "plane", "BIAS_PLANE"}});
    static constexpr std::array texel_counts = {"256", "512", "1024", "2048"};
    bool on = true;
    int texels = 2, pcf = 1, bias = plane;

    /// Draws the depth map, if the sun or the scene has changed.
    void draw(Stage& stage, const glm::dvec3& to_sun) {
        const Scene scene = stage.scene();
        view_ = light_view(to_sun, scene.low, scene.high + glm::dvec3(0, stage.is_displaced() ? 0.3 : 0, 0));
        const Program &plain = depth_.with(), &raised = depth_.with(stage.displaced(Material::floor));
        const int side = 256 << texels;
        map_ = maps_
                   .get({side, view_.clip_from_world, stage.version(), GLuint(plain), GLuint(raised)},
                        [&] {
                            auto map = std::make_unique<DepthTarget>(glm::ivec2(side));
                            map->begin();
                            glClear(GL_DEPTH_BUFFER_BIT);
                            stage.draw(view_.clip_from_world, [&](Material material) -> const Program& {
                                const Program& program = material == Material::floor ? raised : plain;
                                glUseProgram(program);
                                return program;
                            });
                            return map;
                        })
                   .get();
    }

    /// Precondition: draw().
    void set(const Program& program) const {
        program.set("u_light_from_world", glm::mat3(view_.light_from_world));
        program.set("u_light_clip_from_world", view_.clip_from_world);
        program.set("u_shadow", glm::vec3(view_.width / (256 << texels), view_.depth, rounding));
        program.set("u_pcf", pcf);
        map_->bind(4), program.set("s_shadow", 4);
    }

private:
    /// Upper bound of the rounding error in the depth map, in depths: a few units in the last place of a float.
    static constexpr double rounding = 1e-6;

    Programs depth_{"16_environment/scene.vert", "16_environment/depth.frag"};
    LightView view_{};
    Kept<std::unique_ptr<DepthTarget>, int, glm::dmat4, int, GLuint, GLuint> maps_;
    const DepthTarget* map_ = nullptr;
};

}  // namespace relief::court
