// The staff's part of lab 01: see ../truth.h.
#include "truth.h"

#include <limits>

#include "framework/core/image/asset.h"
#include "framework/library/kit/drawn_numbers.h"
#include "framework/staff/reference/height_field.h"
#include "framework/staff/reference/near_plane.h"
#include "framework/staff/reference/surfaces.h"
#include "framework/staff/reference/tangent_space.h"
#include "scene.h"

namespace relief::colonnade {
namespace {

/// A relief, and its depth (a height of 1) in texels.
struct Relief {
    HeightField heights;
    double depth;

    Relief(const char* file, double depth_in_texels)  // assets/SOURCES.md has the depths
        : heights(read_asset(file), true), depth(depth_in_texels) {}
    glm::dvec2 texels(glm::dvec2 uv) const { return uv * glm::dvec2(heights.size()); }
    glm::dvec2 slope(glm::dvec2 uv) const { return depth * heights.central_slope(texels(uv)); }
};

/// The hit of a ray: the smooth surface, with directions in the world, and the texture on it.
struct Sight {
    double t = std::numeric_limits<double>::infinity();
    SurfacePoint point;
    glm::dvec2 uv;
    const Relief* relief = nullptr;
};

template <class Shape>
void look_at(const Shape& shape, const Relief& relief, const Ray& ray, Sight& nearest) {
    const auto hit = first_hit(shape, ray);
    if (!hit || hit->t >= nearest.t) return;
    nearest = {hit->t, point_on(shape, hit->place), hit->place * glm::dvec2(shape.repeat), &relief};
}

/// The floor's quad lies in the xy plane and faces +z, so its space is the world rotated by 90 degrees about x.
glm::dvec3 ground_from_world(glm::dvec3 v) { return {v.x, -v.z, v.y}; }
glm::dvec3 world_from_ground(glm::dvec3 v) { return {v.x, v.z, -v.y}; }

Sight first_sight(const Ray& ray, const Relief& bricks, const Relief& paving) {
    Sight nearest;
    look_at(ground, paving, {ground_from_world(ray.origin), ground_from_world(ray.direction)}, nearest);
    if (nearest.relief) {
        nearest.point.normal = world_from_ground(nearest.point.normal);
        nearest.point.du = world_from_ground(nearest.point.du);
    }
    for (const glm::dvec3 place : places) {
        look_at(column, bricks, {ray.origin - place, ray.direction}, nearest);
        look_at(ball, paving, {ray.origin - place - glm::dvec3(top), ray.direction}, nearest);
    }
    return nearest;
}

/// Returns the direction of the normal in tangent space, not of unit length.
glm::dvec3 direction_of(const Sight& sight, double strength) {
    return glm::dvec3(-strength * sight.relief->slope(sight.uv), 1);
}
glm::dvec3 normal_of(const Sight& sight, double strength) {
    return from_tangent_space(direction_of(sight, strength), sight.point.normal, glm::dvec4(sight.point.du, 1));
}

std::optional<Image> exact_values(const Frame& view, double strength) {
    const Relief bricks("bricks_height.png", 24), paving("paving_height.png", 12);
    const glm::dmat4 clip_from_world = view.camera.clip_from_world();
    return truth_of_rays(view, [&](const Ray& ray) -> std::optional<glm::dvec4> {
        const Sight sight = first_sight(drawn_part(clip_from_world, ray), bricks, paving);
        if (!sight.relief) return {};
        if (view.probe.name == "direction") return glm::dvec4(direction_of(sight, strength), 0);
        if (view.probe.name == "normal") return glm::dvec4(normal_of(sight, strength), 0);
        if (view.probe.name == "uv") return glm::dvec4(sight.relief->texels(sight.uv), 0, 0);
        return {};
    });
}

const decltype(truth)::Provided provided_truth(truth, exact_values);

}  // namespace
}  // namespace relief::colonnade
