// The staff's part of lab 13: see ../truth.h.
#include "truth.h"

#include "framework/library/kit/drawn_numbers.h"
#include "framework/staff/reference/displaced_wall.h"
#include "framework/staff/reference/near_plane.h"

namespace relief::displacement {

namespace {

std::optional<Image> exact_values(const Frame& frame, const DisplacedSurface& surface, const glm::dvec3& to_light) {
    if (frame.probe.name == "winding") {
        if (!surface.patches().is_closed) return {};
        return Image(frame.size.x, frame.size.y, 4);
    }
    if (surface.shape != DisplacedSurface::wall || frame.probe.name == "mip" || frame.probe.name == "place") return {};
    const DisplacedWall wall(surface.heights(), DisplacedSurface::wall_metres, surface.tiles().x,
                             double(surface.scale()));
    const glm::dmat4 clip_from_world = frame.camera.clip_from_world();
    return truth_of_rays(frame, [&](const Ray& ray) -> std::optional<glm::dvec4> {
        const auto seen = wall.look(ray, near_plane(clip_from_world, ray));
        if (!seen) return {};
        if (frame.probe.name == "depth") return glm::dvec4(seen->distance, 0, 0, 0);
        if (frame.probe.name == "shadow") {
            // A micrometre back along the view ray there is only air.
            const glm::dvec3 place = ray.origin + (seen->distance - 1e-6) * ray.direction;
            return glm::dvec4(wall.look({place, to_light}, 0) ? 0 : 1, 0, 0, 0);
        }
        if (frame.probe.name == "slope") return glm::dvec4(seen->slope, 0, 0);
        return glm::dvec4(seen->normal, 0);
    });
}

const decltype(truth)::Provided provided_truth(truth, exact_values);

}  // namespace
}  // namespace relief::displacement
