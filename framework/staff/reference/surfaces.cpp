#include "framework/staff/reference/surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace relief {
namespace {

constexpr double pi = glm::pi<double>();

/// Returns the roots of a t² + 2 b t + c = 0 in ascending order; NaN if there are none. Neither root is computed as a
/// difference, so nothing cancels. The caller must pass coefficients for which b² - a c does not cancel.
std::array<double, 2> roots(double a, double b, double c) {
    if (a == 0) return {-c / (2 * b), -c / (2 * b)};
    const double q = -(b + std::copysign(std::sqrt(b * b - a * c), b));
    const double one = q / a, two = q == 0 ? one : c / q;
    return {std::min(one, two), std::max(one, two)};
}

double share_of_a_turn(double sine, double cosine) {
    const double share = std::atan2(sine, cosine) / (2 * pi);
    return share < 0 ? share + 1 : share;
}

}  // namespace

glm::dvec3 tangent_of(const SurfacePoint& point) {
    return glm::normalize(point.du - glm::dot(point.du, point.normal) * point.normal);
}

SurfacePoint point_on(const QuadShape& quad, glm::dvec2 place) {
    const glm::dvec2 size(quad.width, quad.height);
    return {.position = {(place - 0.5) * size, 0},
            .normal = {0, 0, 1},
            .du = {size.x, 0, 0},
            .dv = {0, size.y, 0},
            .normal_du = {},
            .normal_dv = {}};
}

SurfacePoint point_on(const ColumnShape& column, glm::dvec2 place) {
    const double angle = 2 * pi * place.x, s = std::sin(angle), c = std::cos(angle);
    const double taper = double(column.top_radius) - column.bottom_radius, height = column.height;
    const double radius = column.bottom_radius + taper * place.y;
    // The normal leans by the taper and turns with the angle. It is constant along the height.
    const double slant = std::hypot(height, taper), level = slant > 0 ? height / slant : 1;
    const double rise = slant > 0 ? -taper / slant : 0;
    return {.position = {radius * s, place.y * height, radius * c},
            .normal = {level * s, rise, level * c},
            .du = 2 * pi * radius * glm::dvec3(c, 0, -s),
            .dv = {taper * s, height, taper * c},
            .normal_du = 2 * pi * level * glm::dvec3(c, 0, -s),
            .normal_dv = {}};
}

SurfacePoint point_on(const SphereShape& sphere, glm::dvec2 place) {
    const double around = 2 * pi * (place.x - 0.5), up = pi * (place.y - 0.5), radius = sphere.radius;
    const glm::dvec3 east(std::cos(around), 0, -std::sin(around)), out(std::sin(around), 0, std::cos(around));
    const glm::dvec3 normal = std::cos(up) * out + std::sin(up) * glm::dvec3(0, 1, 0);
    const glm::dvec3 normal_du = 2 * pi * std::cos(up) * east;
    const glm::dvec3 normal_dv = pi * (std::cos(up) * glm::dvec3(0, 1, 0) - std::sin(up) * out);
    return {.position = radius * normal,
            .normal = normal,
            .du = radius * normal_du,
            .dv = radius * normal_dv,
            .normal_du = normal_du,
            .normal_dv = normal_dv};
}

std::optional<SurfaceHit> first_hit(const QuadShape& quad, const Ray& ray) {
    const double t = -ray.origin.z / ray.direction.z;
    if (!(t > 0) || std::isinf(t)) return {};
    const glm::dvec2 place = glm::dvec2(ray.at(t)) / glm::dvec2(quad.width, quad.height) + 0.5;
    if (!(place.x >= 0 && place.x <= 1 && place.y >= 0 && place.y <= 1)) return {};
    return SurfaceHit{t, place};
}

std::optional<SurfaceHit> first_hit(const ColumnShape& column, const Ray& ray) {
    // x² + z² = r(y)², with r linear in y. Start at the ray's point nearest to the axis, so that b² - a c keeps its
    // precision for a far origin.
    const double slope = (double(column.top_radius) - column.bottom_radius) / column.height;
    const glm::dvec2 level(ray.direction.x, ray.direction.z);
    const double reach = glm::dot(level, level);
    const double nearest =
        reach > 0 ? -(ray.origin.x * level.x + ray.origin.z * level.y) / reach : -ray.origin.y / ray.direction.y;
    const glm::dvec3 from = ray.at(nearest);
    const double radius = column.bottom_radius + slope * from.y, widening = slope * ray.direction.y;
    const double a = reach - widening * widening, b = from.x * level.x + from.z * level.y - radius * widening;
    for (const double after : roots(a, b, from.x * from.x + from.z * from.z - radius * radius)) {
        const double t = nearest + after;
        const glm::dvec3 at = from + after * ray.direction;
        const double v = at.y / column.height;
        // The other half of the double cone has a negative radius.
        if (t > 0 && v >= 0 && v <= 1 && radius + widening * after >= 0)
            return SurfaceHit{t, {share_of_a_turn(at.x, at.z), v}};
    }
    return {};
}

std::optional<SurfaceHit> first_hit(const SphereShape& sphere, const Ray& ray) {
    const double reach = glm::dot(ray.direction, ray.direction);
    const double nearest = -glm::dot(ray.origin, ray.direction) / reach;
    const glm::dvec3 from = ray.at(nearest);
    const double half_chord = std::sqrt((double(sphere.radius) * sphere.radius - glm::dot(from, from)) / reach);
    for (const double t : {nearest - half_chord, nearest + half_chord})
        if (t > 0) {
            const glm::dvec3 out = glm::normalize(ray.at(t));
            const double u = share_of_a_turn(-out.x, -out.z);  // u = 0 is at -z
            return SurfaceHit{t, {u, 0.5 + std::atan2(out.y, std::hypot(out.x, out.z)) / pi}};
        }
    return {};
}

}  // namespace relief
