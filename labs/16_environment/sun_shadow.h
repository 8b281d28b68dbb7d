// The sun's depth map in lab 16: the scene as the sun sees it.
#pragma once

#include <memory>

#include "framework/core/gl/depth_target.h"
#include "framework/core/mesh/parallelogram.h"
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
        view_ = view_from(to_sun, stage.scene(), stage.is_displaced());
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
        program.set("u_shadow", glm::vec3(view_.width / (256 << texels), view_.depths, rounding));
        program.set("u_pcf", pcf);
        map_->bind(4), program.set("s_shadow", 4);
    }

private:
    /// Upper bound of the rounding error in the depth map, in depths: a few units in the last place of a float.
    static constexpr double rounding = 1e-6;

    /// The sun looks along -z of the light's space, at a box around the scene.
    struct View {
        glm::dmat3 light_from_world;
        glm::dmat4 clip_from_world;
        double width, depths;  ///< of the box, metres
    };
    static View view_from(const glm::dvec3& to_sun, const Scene& scene, bool is_displaced) {
        const PlaneAxes axes = plane_axes(to_sun);  // valid for a sun at the zenith, too
        const glm::dmat3 light_from_world = glm::transpose(glm::dmat3(axes.right, axes.up, to_sun));
        const double top = is_displaced ? 0.3 : 0;
        glm::dvec3 low(INFINITY), high(-INFINITY);
        for (int i = 0; i < 8; ++i) {
            const glm::dvec3 corner(i & 1 ? scene.high.x : scene.low.x, i & 2 ? scene.high.y + top : scene.low.y,
                                    i & 4 ? scene.high.z : scene.low.z);
            low = glm::min(low, light_from_world * corner), high = glm::max(high, light_from_world * corner);
        }
        const double width = std::max(high.x - low.x, high.y - low.y) * 1.01, depths = (high.z - low.z) * 1.01 + 1e-3;
        const glm::dvec3 middle = (low + high) / 2.0;
        const glm::dmat4 clip_from_light(2 / width, 0, 0, 0, 0, 2 / width, 0, 0, 0, 0, -2 / depths, 0,
                                         -2 * middle.x / width, -2 * middle.y / width, 2 * middle.z / depths, 1);
        return {light_from_world, clip_from_light * glm::dmat4(light_from_world), width, depths};
    }

    Programs depth_{"16_environment/scene.vert", "16_environment/depth.frag"};
    View view_{};
    Kept<std::unique_ptr<DepthTarget>, int, glm::dmat4, int, GLuint, GLuint> maps_;
    const DepthTarget* map_ = nullptr;
};

}  // namespace relief::court
