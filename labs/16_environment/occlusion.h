// Ambient occlusion in lab 16, from the surfaces in the picture.
#pragma once

#include <memory>

#include "framework/core/gl/texel_target.h"
#include "framework/library/kit/view_axes.h"
#include "framework/library/kit/window_triangle.h"
#include "stage.h"

namespace relief::court {

class Occlusion {
public:
    bool on = true;
    int slices = 2, taps = 5;

    /// Draws how open each place of the picture is: at half the resolution of a picture, and at that of a probe.
    void draw(const Frame& frame, Stage& stage) {
        const glm::ivec2 size = frame.probe ? frame.size : glm::max((frame.size + 1) / 2, 1);
        if (!targets_ || targets_->open.size() != size) targets_ = std::make_unique<Targets>(size);
        draw_surfaces(frame, stage);
        search_horizons(frame, stage);
        smooth();
    }

    /// Precondition: draw().
    void set(const Program& program) const { targets_->smoothed.bind(3), program.set("s_open", 3); }

private:
    struct Targets {
        TexelTarget surfaces, open, smoothed;
        explicit Targets(glm::ivec2 size)
            : surfaces(size, {GL_RGBA32F}, false, true), open(size, {GL_RGBA32F}), smoothed(size, {GL_RGBA32F}) {}
    };

    /// Draws the normal and the distance of each place.
    void draw_surfaces(const Frame& frame, Stage& stage) {
        targets_->surfaces.begin();
        constexpr float nothing[] = {0, 0, 0, 0};
        glClearBufferfv(GL_COLOR, 0, nothing);
        glClear(GL_DEPTH_BUFFER_BIT);
        stage.draw(frame.camera.clip_from_world(), [&](Material material) -> const Program& {
            const Program& program = surfaces_.with(stage.displaced(material));
            glUseProgram(program);
            program.set("u_view_from_world", glm::mat3(frame.camera.view_from_world()));
            return program;
        });
    }

    void search_horizons(const Frame& frame, Stage& stage) {
        targets_->open.begin();
        const Program& program = search_.with();
        glUseProgram(program);
        targets_->surfaces.bind(0), program.set("s_surface", 0);
        const double up = view_axes(frame.camera).half_height;
        program.set("u_half", glm::vec2(up * frame.size.x / std::max(1, frame.size.y), up));
        program.set("u_slices", slices);
        program.set("u_taps", taps);
        program.set("u_reach", stage.scene().reach);
        program.set("u_most", (stage.is_court() ? 0.25 : 1.0) * targets_->open.size().y);
        window_.draw();
    }

    void smooth() {
        targets_->smoothed.begin();
        const Program& program = smooth_.with();
        glUseProgram(program);
        targets_->open.bind(0), program.set("s_open", 0);
        window_.draw();
    }

    Programs surfaces_{"16_environment/scene.vert", "16_environment/near.frag"};
    Programs search_{"common/window.vert", "16_environment/occlusion.frag"};
    Programs smooth_{"common/window.vert", "16_environment/smooth.frag"};
    WindowTriangle window_;
    std::unique_ptr<Targets> targets_;
};

}  // namespace relief::court
