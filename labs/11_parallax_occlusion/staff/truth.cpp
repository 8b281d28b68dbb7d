// The staff's part of lab 11: see ../truth.h.
#include "truth.h"

#include "framework/library/kit/drawn_numbers.h"
#include "framework/staff/reference/near_plane.h"
#include "framework/staff/reference/relief_sight.h"

namespace relief::occlusion {
namespace {

std::function<Image(const Frame&)> exact_values(const Probe& probe, const Mesh& mesh, const ReliefMapping& mapping,
                                                const Image& heights) {
    if (probe.name != "uv" && probe.name != "depth") return {};
    return [is_uv = probe.name == "uv", field = HeightField(heights, true), sights = ReliefSights(mesh),
            mapping](const Frame& frame) {
        const glm::dmat4 clip_from_world = frame.camera.clip_from_world();
        return truth_of_rays(frame, [&](const Ray& ray) -> std::optional<glm::dvec4> {
            const auto sight = sights.look(ray, mapping, near_plane(clip_from_world, ray));
            if (!sight) return {};
            double t = 0;
            if (!sight->faces_away) {
                const auto hit = field.first_hit(sight->ray.in_texels(), 1);
                t = hit ? hit->t : 1;
            }
            if (is_uv) return glm::dvec4(sight->ray.texel + t * sight->ray.march, 0, 0);
            return glm::dvec4(sight->distance + t * sight->metres_to_ground, 0, 0, 0);
        });
    };
}

const decltype(truth)::Provided provided_truth(truth, exact_values);

}  // namespace
}  // namespace relief::occlusion
