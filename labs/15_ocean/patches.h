// The patches of lab 15's sea: rings around the place below the eye, out to the horizon. Near the eye waves raise them.
#pragma once

#include "framework/core/kit/view_axes.h"
#include "water.h"

namespace relief::ocean {

class Patches {
public:
    bool displace = true;
    float budget = 3;  ///< error of the raised waves, pixels

    /// Returns whether some water in the picture is so near that flat water would exceed the budget.
    bool are_raised(const Frame& frame, const Water& water) const {
        if (!displace) return false;
        double down = 0;  // largest downward component of a unit ray
        for (const glm::dvec2 clip : {glm::dvec2(0, -1), {-1, -1}, {1, -1}, {0, 0}, {0, 1}})
            down = std::max(down, -frame.camera.ray(clip).direction.y);
        if (down > 0.95) down = 1;
        const double nearest = std::max(0.0, frame.camera.eye().y - water.highest()) / std::max(down, 1e-9);
        return down > 0 && water.segment_exponent(tolerated(frame, nearest)) < Water::endless;
    }

    /// Sets the uniforms of sea.vert, sea.tesc and sea.tese. The sea has no end, so places are relative to the eye, in
    /// double precision up to here.
    void set(const Program& program, const Frame& frame, const Water& water, bool is_raised) const {
        const glm::dvec3 eye = frame.camera.eye();
        program.set("u_clip_from_eye", frame.camera.clip_from_world() *
                                           glm::dmat4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, eye.x, eye.y, eye.z, 1));
        program.set("u_eye_height", eye.y);
        program.set("u_near", std::min(0.1, 0.02 * frame.camera.orbit().distance));
        program.set("u_highest", is_raised ? water.highest() : 0.0);
        const double first_ring = std::clamp(std::abs(eye.y), 0.5, 1e4),
                     last_ring = 4e4 * std::max(1.0, first_ring / 10),
                     ratio = std::pow(last_ring / first_ring, 1.0 / (rings - 1));
        program.set("u_rings", glm::vec3(sectors, first_ring, ratio));
        for (int ring = 0; ring <= rings; ++ring) {
            const double radius = ring == 0 ? 0 : first_ring * std::pow(ratio, ring - 1);
            const double error = tolerated(frame, std::hypot(radius, eye.y));
            program.set(fmt::format("u_segments[{}]", ring).c_str(),
                        is_raised ? water.segment_exponent(error) : Water::endless);
        }
    }

    /// Precondition: the program is in use.
    void draw() const {
        glBindVertexArray(nothing_.layout());
        glPatchParameteri(GL_PATCH_VERTICES, 4);
        glDrawArrays(GL_PATCHES, 0, rings * sectors * 4);
    }

private:
    static constexpr int rings = 26, sectors = 48;

    /// Returns the error in metres that covers the budget in pixels, at a distance in metres.
    double tolerated(const Frame& frame, double distance) const {
        return double(budget) * distance * 2 * view_axes(frame.camera).half_height / frame.size.y;
    }

    GpuMesh nothing_ = upload([] { return Mesh{}; });
};

}  // namespace relief::ocean
