// The staff's part of lab 05: see ../truth.h.
#include "truth.h"

#include "framework/core/base/error.h"
#include "framework/library/kit/drawn_numbers.h"

namespace relief::basis {
namespace {

/// Returns the u and v of the surface at the first triangle that a ray hits, from either side (Möller and Trumbore
/// 1997).
std::optional<glm::dvec2> place_seen(const CoarseMesh& coarse, const Ray& ray) {
    std::optional<glm::dvec2> seen;
    double nearest = std::numeric_limits<double>::infinity();
    const auto& [mesh, places] = coarse;
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const uint32_t a = mesh.indices[i], b = mesh.indices[i + 1], c = mesh.indices[i + 2];
        const glm::dvec3 p(mesh.vertices[a].position);
        const glm::dvec3 e1 = glm::dvec3(mesh.vertices[b].position) - p, e2 = glm::dvec3(mesh.vertices[c].position) - p;
        const glm::dvec3 across = glm::cross(ray.direction, e2), from = ray.origin - p;
        const double determinant = glm::dot(e1, across);
        if (determinant == 0) continue;
        const double s = glm::dot(from, across) / determinant;
        const glm::dvec3 q = glm::cross(from, e1);
        const double t = glm::dot(ray.direction, q) / determinant, distance = glm::dot(e2, q) / determinant;
        if (s < 0 || t < 0 || s + t > 1 || distance <= 0 || distance >= nearest) continue;
        nearest = distance;
        seen = (1 - s - t) * places[a] + s * places[b] + t * places[c];
    }
    return seen;
}

std::optional<Image> exact_values(const Frame& frame, const CoarseMesh& mesh, Shape shape, double shear) {
    return truth_of_rays(frame, [&](const Ray& ray) -> std::optional<glm::dvec4> {
        const auto seen = place_seen(mesh, ray);
        if (!seen) return {};
        const Place place = place_on(shape, *seen, shear);
        glm::dvec3 value(place.tangent);
        // The bitangent of the frame is perpendicular to dP/du. So is dP/dv on a surface of revolution, but not on a
        // sheared quad.
        if (frame.probe.name == "dp_dv" && shape == Shape::quad)
            value = {0, 1, 0};
        else if (frame.probe.name == "bitangent" || frame.probe.name == "dp_dv")
            value = place.tangent.w * glm::cross(place.normal, value);
        if (frame.probe.name == "frame") value = {1, 0, place.tangent.w};
        return glm::dvec4(value, 0);
    });
}

const decltype(truth)::Provided provided_truth(truth, exact_values);

}  // namespace
}  // namespace relief::basis
