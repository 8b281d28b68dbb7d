// The staff's part of lab 10: see ../truth.h.
#include "truth.h"

#include "framework/library/kit/drawn_numbers.h"
#include "framework/staff/reference/near_plane.h"
#include "framework/staff/reference/relief_sight.h"

namespace relief::offsets {
namespace {

glm::dvec4 value_of(const std::string& probe, const ReliefSight& sight, const HeightField& heights) {
    if (probe == "ray") return {sight.ray.march, 0, 0};
    double t = 0;
    if (!sight.faces_away) {
        const auto hit = heights.first_hit(sight.ray.in_texels(), 1);
        t = hit ? hit->t : 1;
    }
    if (probe == "depth") return {sight.distance + t * sight.metres_to_ground, 0, 0, 0};
    return {sight.ray.texel + t * sight.ray.march, 0, 0};
}

std::function<Image(const Frame&)> exact_values(const Probe& probe, const ReliefSurface& surface) {
    if (probe.name == "steps") return {};
    return [name = probe.name, sights = ReliefSights(surface.mesh()), heights = HeightField(surface.heights(), true),
            mapping = surface.mapping()](const Frame& frame) {
        const glm::dmat4 clip_from_world = frame.camera.clip_from_world();
        return truth_of_rays(frame, [&](const Ray& ray) -> std::optional<glm::dvec4> {
            const auto sight = sights.look(ray, mapping, near_plane(clip_from_world, ray));
            if (!sight) return {};
            return value_of(name, *sight, heights);
        });
    };
}

const decltype(truth)::Provided provided_truth(truth, exact_values);

}  // namespace
}  // namespace relief::offsets
