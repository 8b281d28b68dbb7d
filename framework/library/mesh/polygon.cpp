#include "framework/library/mesh/polygon.h"

#include <cmath>

namespace relief {
namespace {

/// Returns twice the signed area of a triangle, positive when it is counter-clockwise.
double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Projects the polygon along the axis on which its area is largest, so that it is counter-clockwise.
std::vector<glm::dvec2> flatten(std::span<const glm::dvec3> corners) {
    const glm::dvec3 area = vector_area(corners), size = glm::abs(area);
    const int drop = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    int right = (drop + 1) % 3, up = (drop + 2) % 3;
    if (area[drop] < 0) std::swap(right, up);
    std::vector<glm::dvec2> flat;
    flat.reserve(corners.size());
    for (const glm::dvec3& corner : corners) flat.emplace_back(corner[right], corner[up]);
    return flat;
}

/// A polygon from which ears are clipped one after another.
class EarClipper {
public:
    explicit EarClipper(std::span<const glm::dvec2> corners) : corners_(corners), ring_(corners.size()) {
        const auto count = static_cast<uint32_t>(corners.size());
        for (uint32_t i = 0; i < count; ++i) ring_[i] = {(i + count - 1) % count, (i + 1) % count};
        for (uint32_t i = 0; i < count; ++i)
            if (!is_convex(i)) reflex_.push_back(i);
        for (uint32_t i = 0; i < count; ++i) ring_[i].is_ear = is_ear(i);
    }

    bool is_convex_polygon() const { return reflex_.empty(); }

    void clip(std::vector<uint32_t>& triangles) {
        uint32_t at = 0;
        size_t left = corners_.size(), misses = 0;
        while (left > 2) {
            const auto [before, after, ear] = ring_[at];
            // Only a polygon that crosses itself runs out of ears. Then clip any corner.
            if (ear || misses > left) {
                triangles.insert(triangles.end(), {before, at, after});
                ring_[before].after = after, ring_[after].before = before;
                std::erase(reflex_, at);
                for (const uint32_t neighbour : {before, after}) {
                    if (is_convex(neighbour)) std::erase(reflex_, neighbour);
                    ring_[neighbour].is_ear = is_ear(neighbour);
                }
                --left;
                misses = 0;
                at = ring_[after].after;  // not the neighbour, which would give a fan of needle-like triangles
            } else {
                ++misses;
                at = after;
            }
        }
    }

private:
    struct Link {
        uint32_t before, after;
        bool is_ear = false;
    };

    const glm::dvec2& corner(uint32_t i) const { return corners_[i]; }
    bool is_convex(uint32_t i) const { return turn(corner(ring_[i].before), corner(i), corner(ring_[i].after)) >= 0; }

    /// Returns whether a corner is convex and no reflex corner lies in its triangle.
    bool is_ear(uint32_t i) const {
        const glm::dvec2 &a = corner(ring_[i].before), &b = corner(i), &c = corner(ring_[i].after);
        if (turn(a, b, c) < 0) return false;
        for (const uint32_t other : reflex_) {
            const glm::dvec2& p = corner(other);
            if (p != a && p != b && p != c && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0)
                return false;
        }
        return true;
    }

    std::span<const glm::dvec2> corners_;
    std::vector<Link> ring_;
    std::vector<uint32_t> reflex_;
};

void cut_quad(std::span<const glm::dvec3> corners, std::span<const glm::dvec2> flat, std::vector<uint32_t>& triangles) {
    const bool has_02 = turn(flat[0], flat[1], flat[2]) >= 0 && turn(flat[0], flat[2], flat[3]) >= 0;
    const bool has_13 = turn(flat[0], flat[1], flat[3]) >= 0 && turn(flat[1], flat[2], flat[3]) >= 0;
    const bool prefers_02 = glm::distance(corners[0], corners[2]) <= glm::distance(corners[1], corners[3]);
    if (has_02 == has_13 ? prefers_02 : has_02)
        triangles.insert(triangles.end(), {0, 1, 2, 0, 2, 3});
    else
        triangles.insert(triangles.end(), {0, 1, 3, 1, 2, 3});
}

}  // namespace

glm::dvec3 vector_area(std::span<const glm::dvec3> corners) {
    glm::dvec3 sum(0);
    for (size_t i = 2; i < corners.size(); ++i) sum += glm::cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
    return sum / 2.0;
}

void triangulate(std::span<const glm::dvec3> corners, std::vector<uint32_t>& triangles) {
    if (corners.size() < 3) return;
    if (corners.size() == 3) {
        triangles.insert(triangles.end(), {0, 1, 2});
        return;
    }
    const std::vector<glm::dvec2> flat = flatten(corners);
    if (corners.size() == 4) return cut_quad(corners, flat, triangles);
    EarClipper clipper(flat);
    if (!clipper.is_convex_polygon()) return clipper.clip(triangles);
    for (uint32_t i = 2; i < corners.size(); ++i) triangles.insert(triangles.end(), {0, i - 1, i});
}

}  // namespace relief
