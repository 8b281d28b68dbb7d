// A vertical section through the light of lab 08's lamp.
#pragma once

#include <algorithm>

#include "framework/library/kit/drawn_numbers.h"
#include "framework/library/kit/window_triangle.h"
#include "truth.h"

namespace relief::materials {

class LampCut {
public:
    void draw(const Frame& frame, const Lights& lights) {
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glViewport(0, 0, frame.size.x, frame.size.y);
        const Program& program = program_.with(frame.probe);
        glUseProgram(program);
        lights.set_lamp(program);
        program.set("u_middle", glm::vec2(frame.size) / 2.0f);
        program.set("u_pixel", metres_per_pixel(frame.size));
        window_.draw();
    }

    /// Returns the exact values of the probe `lamp`.
    static std::optional<Image> truth(glm::ivec2 size, const Probe& probe, const Lights& lights) {
        if (probe.name != "lamp" || !true_share) return {};
        return image_of_values(size, [&](int x, int y) {
            const glm::dvec2 off =
                (glm::dvec2(x, size.y - 1 - y) + 0.5 - glm::dvec2(size) / 2.0) * metres_per_pixel(size);
            return glm::dvec4(true_share(lights, lights.place + glm::dvec3(off, 0)).value_or(0), 0, 0, 0);
        });
    }

private:
    static double metres_per_pixel(glm::ivec2 size) { return 5.0 / std::max(1, std::min(size.x, size.y)); }

    Programs program_{"common/window.vert", "08_obj_materials/cone.frag"};
    WindowTriangle window_;
};

}  // namespace relief::materials
