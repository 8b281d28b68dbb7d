// The staff's part of lab 06: see ../truth.h.
#include "truth.h"

#include "framework/core/image/asset.h"
#include "framework/library/kit/drawn_numbers.h"
#include "framework/staff/reference/height_field.h"
#include "framework/staff/reference/near_plane.h"
#include "framework/staff/reference/surfaces.h"

namespace relief::frames {
namespace {

struct Sight {
    SurfacePoint point;  ///< du and dv are along the map's u and v, before it is turned
    glm::dvec2 uv;       ///< in tiles of the map
};

template <class Shape>
std::optional<Sight> look_at(const Shape& shape, const Ray& ray) {
    const auto hit = first_hit(shape, ray);
    if (!hit) return {};
    Sight sight{point_on(shape, hit->place), hit->place * glm::dvec2(shape.repeat)};
    sight.point.du /= double(shape.repeat.x), sight.point.dv /= double(shape.repeat.y);
    return sight;
}

/// Returns where a ray enters the cube.
std::optional<Sight> look_at_cube(const Ray& ray) {
    const double half = double(cube.size.x) / 2;
    for (int i = 0; i < 6; ++i) {
        const CubeFace& face = cube_face(i);
        const double towards = -glm::dot(ray.direction, face.normal);
        if (towards <= 0) continue;
        const double t = (glm::dot(ray.origin, face.normal) - half) / towards;
        const glm::dvec3 position = ray.origin + t * ray.direction;
        const glm::dvec2 place(glm::dot(position, face.right), glm::dot(position, face.up));
        if (t < 0 || std::abs(place.x) > half || std::abs(place.y) > half) continue;
        const double tile = 2 * half;
        return Sight{{position, face.normal, tile * face.right, tile * face.up, {}, {}}, place / tile + 0.5};
    }
    return {};
}

std::optional<Sight> look(const Pose& pose, const Ray& ray) {
    if (pose.shape == Shape::sphere) return look_at(sphere, ray);
    if (pose.shape == Shape::column) return look_at(column, ray);
    if (pose.shape == Shape::cube) return look_at_cube(ray);
    auto sight = look_at(wall, ray);
    if (sight) {
        const double side = sight->point.position.x < 0 ? -1 : 1;
        sight->uv.x = std::abs(sight->point.position.x), sight->point.du = {side, 0, 0};
    }
    return sight;
}

glm::dvec3 normal_of(const Sight& sight, const Pose& pose, const HeightField& bricks) {
    const double c = std::cos(pose.turn_rad), s = std::sin(pose.turn_rad);
    const glm::dvec2 from_middle = sight.uv - 0.5;
    const glm::dvec2 uv =
        glm::dvec2(c * from_middle.x - s * from_middle.y, s * from_middle.x + c * from_middle.y) + 0.5;
    const glm::dvec2 slope =
        pose.strength * bricks_depth_in_texels * bricks.central_slope(uv * glm::dvec2(bricks.size()));
    // The frame of the map has unit axes along the turned u and v.
    const auto& [position, normal, du, dv, normal_du, normal_dv] = sight.point;
    const glm::dvec3 along_u = glm::normalize(c * du - s * dv);
    const double side = glm::dot(glm::cross(du, dv), normal) < 0 ? -1 : 1;
    return -slope.x * along_u - slope.y * side * glm::cross(normal, along_u) + normal;
}

std::optional<Image> exact_values(const Frame& frame, const Pose& pose) {
    if (glm::determinant(pose.world_from_model) == 0) return {};
    const HeightField bricks(read_asset("bricks_height.png"), true);
    const glm::dmat4 model_from_world = glm::inverse(pose.world_from_model);
    const glm::dmat3 normals = glm::transpose(glm::dmat3(model_from_world));
    const glm::dmat4 clip_from_world = frame.camera.clip_from_world();
    return truth_of_rays(frame, [&](const Ray& whole) -> std::optional<glm::dvec4> {
        const Ray ray = drawn_part(clip_from_world, whole);
        const auto sight = look(pose, {glm::dvec3(model_from_world * glm::dvec4(ray.origin, 1)),
                                       glm::dmat3(model_from_world) * ray.direction});
        if (!sight) return {};
        return glm::dvec4(glm::normalize(normals * normal_of(*sight, pose, bricks)), 0);
    });
}

const decltype(truth)::Provided provided_truth(truth, exact_values);

}  // namespace
}  // namespace relief::frames
