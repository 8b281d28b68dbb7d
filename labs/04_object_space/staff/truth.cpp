// The staff's part of lab 04: see ../truth.h.
#include "truth.h"

#include "framework/library/kit/drawn_numbers.h"
#include "framework/staff/reference/displaced.h"
#include "quilt.h"

namespace relief::quilt {
namespace {

std::optional<Image> exact_values(const Frame& frame, double rate, const glm::dmat4& world_from_model) {
    const glm::dmat4 model_from_world = glm::inverse(world_from_model);
    return truth_of_rays(frame, [&](const Ray& ray) -> std::optional<glm::dvec4> {
        const Ray local{glm::dvec3(model_from_world * glm::dvec4(ray.origin, 1)),
                        glm::dmat3(model_from_world) * ray.direction};
        // A twist about its axis keeps the column's shape, and only rotates its uv.
        const auto hit = first_hit(column, local);
        if (!hit) return {};
        const double angle = rate * hit->place.y * column.height;
        const glm::dvec2 rest(hit->place.x - angle / (2 * glm::pi<double>()), hit->place.y);
        const auto base = point_on(column, rest);
        const double c = std::cos(angle), s = std::sin(angle);
        const auto twist = [&](const glm::dvec3& p) {
            return glm::dmat3({c, 0, -s}, {rate * (p.z * c - p.x * s), 1, -rate * (p.x * c + p.z * s)}, {s, 0, c});
        };
        if (frame.probe.name == "moved")
            return glm::dvec4(twist(base.position) * (glm::normalize(base.du) + glm::normalize(base.dv)), 0);
        const DisplacedPoint point = displace(base, {height(rest), slope(rest)}, scale);
        const glm::dvec3 normal = glm::normalize(glm::dmat3(world_from_model) *
                                                 (glm::transpose(glm::inverse(twist(point.position))) * point.normal));
        return glm::dvec4(normal, 0);
    });
}

const decltype(truth)::Provided provided_truth(truth, exact_values);

}  // namespace
}  // namespace relief::quilt
