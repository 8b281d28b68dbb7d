// The staff's part of lab 13: see ../truth.h.
#include "truth.h"

#include "framework/library/kit/drawn_numbers.h"
#include "framework/staff/reference/displaced.h"
#include "framework/staff/reference/height_field.h"
#include "framework/staff/reference/near_plane.h"

namespace relief::displacement {

namespace {

/// The part of a ray within a box, in metres along the ray. It is empty if `begin` is greater than `end`.
struct Stretch {
    double begin = 0, end = std::numeric_limits<double>::infinity();
};
Stretch within(const Ray& ray, const glm::dvec3& low, const glm::dvec3& high) {
    Stretch inside;
    for (int i = 0; i < 3; ++i) {
        double enters = (low[i] - ray.origin[i]) / ray.direction[i];
        double leaves = (high[i] - ray.origin[i]) / ray.direction[i];
        if (enters > leaves) std::swap(enters, leaves);
        if (ray.direction[i] == 0) {
            if (ray.origin[i] < low[i] || ray.origin[i] > high[i]) return {1, 0};
            continue;
        }
        inside.begin = std::max(inside.begin, enters), inside.end = std::min(inside.end, leaves);
    }
    return inside;
}

/// A displaced wall of `metres` x `metres`, centred in the plane z = 0. The relief is `scale` metres deep.
class Wall {
public:
    Wall(const Image& heights, double metres, double tiles, double scale)
        : above_(heights, true),
          below_(upside_down(heights), true),
          metres_(metres),
          scale_(scale),
          tiles_(tiles / metres),
          texels_(tiles / metres * glm::dvec2(above_.size())) {}

    struct Seen {
        double distance;
        glm::dvec2 slope;  ///< heights per tile
        glm::dvec3 normal;
    };
    /// Looks for the first hit from the distance `begin` on.
    std::optional<Seen> look(const Ray& ray, double begin) const {
        const double half = metres_ / 2;
        Stretch stretch = within(ray, {-half, -half, -scale_}, {half, half, 0});
        stretch.begin = std::max(stretch.begin, begin);
        if (stretch.begin > stretch.end) return {};
        if (scale_ == 0) return seen(stretch.begin, at_texel(ray, stretch.begin));
        const glm::dvec3 enters = ray.origin + stretch.begin * ray.direction;
        const glm::dvec3 unit(texels_, 1 / scale_);  // texels and heights per metre
        Ray inside{(enters + glm::dvec3(half, half, scale_)) * unit, ray.direction * unit};
        const bool from_below = inside.origin.z < above_.height(inside.origin);
        if (from_below) inside.origin.z = 1 - inside.origin.z, inside.direction.z = -inside.direction.z;
        const auto hit = (from_below ? below_ : above_).first_hit(inside, stretch.end - stretch.begin);
        if (!hit) return {};
        return seen(stretch.begin + hit->t, hit->texel);
    }

private:
    glm::dvec2 at_texel(const Ray& ray, double t) const {
        return (glm::dvec2(ray.origin + t * ray.direction) + metres_ / 2) * texels_;
    }
    Seen seen(double t, glm::dvec2 texel) const {
        // Fragments compute the slope by the same central difference.
        const glm::dvec2 slope = above_.central_slope(texel) * glm::dvec2(above_.size());
        return {t, slope, glm::normalize(glm::dvec3(-slope * tiles_ * scale_, 1))};
    }
    static Image upside_down(Image heights) {
        for (float& value : heights.values) value = 1 - value;
        return heights;
    }

    HeightField above_, below_;
    double metres_, scale_, tiles_;  ///< metres; metres; tiles per metre
    glm::dvec2 texels_;              ///< texels per metre
};

std::optional<Image> exact_values(const Frame& frame, const DisplacedSurface& surface, const glm::dvec3& to_light) {
    if (frame.probe.name == "winding") {
        if (!surface.patches().is_closed) return {};
        return Image(frame.size.x, frame.size.y, 4);
    }
    if (surface.shape != DisplacedSurface::wall || frame.probe.name == "mip" || frame.probe.name == "place") return {};
    const Wall wall(surface.heights(), DisplacedSurface::wall_metres, surface.tiles().x, double(surface.scale()));
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
