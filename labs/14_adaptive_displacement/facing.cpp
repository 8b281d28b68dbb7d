#include "facing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relief {
namespace {

/// Returns the largest singular value of the matrix with the columns u and v.
double most_of(const glm::dvec3& u, const glm::dvec3& v) {
    const double uu = glm::dot(u, u), vv = glm::dot(v, v), uv = glm::dot(u, v);
    return std::sqrt((uu + vv + std::hypot(uu - vv, 2 * uv)) / 2);
}

/// The sides of a patch at a corner: a leads to the next corner, b to the previous one. `area` is the signed area of
/// their parallelogram as seen along an axis.
struct Span {
    glm::dvec3 a, b;
    double area;
};

/// The corners of a patch and the axis along which they are seen. Numbers of corners wrap around.
class Corners {
public:
    Corners(std::span<const PatchCorner> patch, const glm::dvec3& axis)
        : patch_(patch),
          axis_(axis),
          e_(glm::normalize(glm::cross(axis, std::abs(axis.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)))),
          f_(glm::cross(axis, e_)) {}

    glm::dvec3 direction(size_t i) const { return glm::dvec3(patch_[i % patch_.size()].direction); }
    glm::dvec3 before(size_t i) const { return direction(i + patch_.size() - 1); }

    /// Returns the sides at corner i of the patch whose corners are moved `depth` metres against their directions.
    Span span(size_t i, double depth) const {
        const auto place = [&](size_t k) {
            return glm::dvec3(patch_[k % patch_.size()].vertex.position) - depth * direction(k);
        };
        Span span{place(i + 1) - place(i), place(i + patch_.size() - 1) - place(i), 0};
        span.area = glm::dot(axis_, glm::cross(span.a, span.b));
        return span;
    }

    /// Returns the upper bound of the change per metre, seen along the axis, of a vector that is linear over the corner
    /// and changes by da along span.a and by db along span.b.
    double rate(const Span& span, const glm::dvec3& da, const glm::dvec3& db) const {
        const auto along = [&](const glm::dvec3& way) {  // multiplied by the area
            return da * glm::dot(axis_, glm::cross(way, span.b)) + db * glm::dot(axis_, glm::cross(span.a, way));
        };
        return most_of(along(e_), along(f_)) / span.area;
    }

private:
    std::span<const PatchCorner> patch_;
    glm::dvec3 axis_, e_, f_;
};

/// Returns the sphere, axis and spread of a patch. The other members have the values of a patch that folds over.
Facing folded(std::span<const PatchCorner> patch) {
    const size_t n = patch.size();
    const auto position = [&](size_t i) { return glm::dvec3(patch[i % n].vertex.position); };
    const auto direction = [&](size_t i) { return glm::dvec3(patch[i % n].direction); };
    Facing facing{};
    glm::dvec3 centre(0);
    for (size_t i = 0; i < n; ++i) centre += position(i) / double(n);
    double radius = 0;
    for (size_t i = 0; i < n; ++i) radius = std::max(radius, glm::distance(centre, position(i)));
    facing.sphere = {centre, radius * (1 + 1e-5)};  // for rounding to float
    const glm::dvec3 across = n == 4 ? glm::cross(position(2) - position(0), position(3) - position(1))
                                     : glm::cross(position(1) - position(0), position(2) - position(0));
    facing.axis = glm::length(across) > 0 ? glm::normalize(across) : direction(0);
    for (size_t i = 0; i < n; ++i) facing.spread = std::max(facing.spread, glm::distance(facing.axis, direction(i)));
    // Between directions that differ by 90 degrees or more any direction may lie. NaN becomes 2, too.
    if (!(facing.spread < std::sqrt(2.0))) facing.spread = 2;
    facing.flat_rise = facing.rise = std::numeric_limits<double>::infinity();
    facing.skew = facing.length = 1;
    return facing;
}

/// Returns whether an edge or a corner reads heights elsewhere on the map than the inside does. Then the slope of the
/// inside does not bound the steps between them. Offsets by whole tiles do not count.
bool has_jump(std::span<const PatchCorner> patch) {
    const auto is_whole = [](glm::vec2 tiles) { return tiles == glm::round(tiles); };
    for (size_t i = 0; i < patch.size(); ++i) {
        const PatchCorner &here = patch[i], &there = patch[(i + 1) % patch.size()];
        const glm::vec2 begin = glm::vec2(here.edge_uv) - here.vertex.uv,
                        end = glm::vec2(here.edge_uv.z, here.edge_uv.w) - there.vertex.uv;
        if (begin != end || !is_whole(begin) || !is_whole(here.height_uv - here.vertex.uv)) return true;
    }
    return false;
}

}  // namespace

Facing facing_of(std::span<const PatchCorner> patch, const PatchHeights& heights, double scale) {
    Facing facing = folded(patch);
    const glm::dvec3 axis = facing.axis;
    const double shortest = 1 - facing.spread * facing.spread / 2;  // lower bound of the length of D, see facing.h
    if (shortest <= 0) return facing;

    const Corners corners(patch, axis);
    const double middle = scale * (1 - (double(heights.lowest) + double(heights.highest)) / 2),
                 uneven = scale * (double(heights.highest) - double(heights.lowest)) / 2;
    double flat_rise = 0, rise = 0, stretch = 0, turn = 0, longest = 0, cosine = 0;
    double area = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < patch.size(); ++i) {
        const Span flat = corners.span(i, 0), inner = corners.span(i, middle);
        if (!(flat.area > 0 && inner.area > 0)) return facing;
        flat_rise =
            std::max(flat_rise, corners.rate(flat, axis * glm::dot(axis, flat.a), axis * glm::dot(axis, flat.b)));
        rise = std::max(rise, corners.rate(inner, axis * glm::dot(axis, inner.a), axis * glm::dot(axis, inner.b)));
        stretch = std::max(stretch, corners.rate(inner, flat.a, flat.b));
        turn = std::max(turn, corners.rate(inner, corners.direction(i + 1) - corners.direction(i),
                                           corners.before(i) - corners.direction(i)));
        for (const Span& span : {flat, inner}) {
            const glm::dvec3 a = span.a - axis * glm::dot(axis, span.a), b = span.b - axis * glm::dot(axis, span.b);
            longest = std::max({longest, glm::dot(a, a), glm::dot(b, b)});
            area = std::min(area, span.area);
            cosine = std::max(cosine, std::abs(glm::dot(a, b)) / (glm::length(a) * glm::length(b)));
        }
    }
    facing.flat_rise = flat_rise;
    facing.length = longest / area;
    facing.skew = 1 / std::sqrt(std::max(1 - cosine, 1e-12));
    if (has_jump(patch)) return facing;
    // The displaced patch is p - depth d with a unit direction d. The smooth patch p - middle D differs from it
    // by (depth - middle) d + middle (d - D). The second term is not 0, because D is not of unit length.
    const double deeper = scale * double(heights.slope) * stretch;
    const double turned = uneven * turn / shortest +
                          std::abs(middle) * turn * (facing.spread * facing.spread / 2 + 2 * facing.spread) / shortest;
    facing.rise = rise + deeper + turned;
    facing.shift = deeper * facing.spread + turned;
    return facing;
}

}  // namespace relief
